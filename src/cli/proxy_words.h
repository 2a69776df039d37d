#pragma once
// cli/proxy_words.h -- 'object=share': which objects get a proxy, and how simple it is.
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/result.h"
#include "cli/verb.h"
#include "scene/scene.h"

namespace luminist {

/// As they were typed: an object's name, or a pattern with '*', '=' and a share of its triangles.
struct ProxyWords {
  std::vector<std::string> shadow;
  std::vector<std::string> shading;
};

/// --shadow-proxy and --shading-proxy.
void declare_proxies(CLI::App& app, ProxyWords& words);

/// A share for every object that was named, 0 for the others.
struct ProxyShares {
  std::vector<double> shadow;   ///< [objects]
  std::vector<double> shading;  ///< [objects]
};

/// Of words that name the same object the last counts. errors kUsage: no such object, with the nearest name; no share,
/// or one that is not in (0,1].
Result<ProxyShares> proxy_shares(const ProxyWords& words, const Scene& scene);

/// Makes the proxies of the objects that show a mesh, one for all that want the same: shadow meshes, and normals.
/// Objects that want other normals than the rest get a copy of the mesh. Adds what was done to the report, as lists
/// "shadow_proxies" and "shading_proxies", and in words. Meshes that are added stand behind all others.
void add_proxies(const ProxyShares& shares, std::size_t mesh, Scene& scene, nlohmann::ordered_json& json,
                 std::string& text);

}  // namespace luminist
