#include "cli/proxy_words.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/pattern.h"
#include "params/param_text.h"
#include "prep/proxy.h"

namespace luminist {
namespace {

using OrderedJson = nlohmann::ordered_json;
using Objects = std::vector<std::size_t>;

Error bad_words(std::string what, const char* flag, std::string hint) {
  return {ErrorKind::kUsage, std::move(what), "", flag, std::move(hint)};
}

Error no_object(const std::string& pattern, const Scene& scene, const char* flag) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  const std::string nearest = nearest_name(pattern, names);
  return bad_words(fmt::format("the scene has no object \"{}\"", pattern), flag,
                   !nearest.empty() ? fmt::format("did you mean \"{}\"?", nearest)
                                    : fmt::format("it has {}", fmt::join(names, ", ")));
}

/// Reads 'object=share' words into a list of shares.
Result<std::vector<double>> shares_of(const std::vector<std::string>& words, const Scene& scene, const char* flag) {
  std::vector<double> shares(scene.objects.size(), 0.0);
  for (const std::string& word : words) {
    const std::size_t sign = word.rfind('=');
    const std::string pattern = word.substr(0, sign);
    const std::optional<double> share =
        sign == std::string::npos ? std::nullopt : parse_number(std::string_view(word).substr(sign + 1));
    if (!share || !(*share > 0.0) || *share > 1.0) {
      return bad_words(fmt::format("\"{}\" names no share above 0 and up to 1", word), flag,
                       fmt::format("write '{}=0.1' to keep a tenth of the triangles", pattern));
    }
    bool any = false;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (!matches(pattern, scene.objects[i].name)) continue;
      shares[i] = *share;
      any = true;
    }
    if (!any) return no_object(pattern, scene, flag);
  }
  return shares;
}

/// The objects that show a mesh, by their share.
std::map<double, Objects> grouped(const std::vector<double>& shares, std::size_t mesh, const Scene& scene) {
  std::map<double, Objects> groups;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (static_cast<std::size_t>(scene.objects[i].mesh) == mesh) groups[shares[i]].push_back(i);
  }
  return groups;
}

std::vector<std::string> names_of(const Objects& objects, const Scene& scene) {
  std::vector<std::string> names;
  for (const std::size_t i : objects) names.push_back(scene.objects[i].name);
  return names;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void add_shadow_proxy(double share, const Objects& objects, std::size_t mesh, Scene& scene, OrderedJson& json,
                      std::string& text) {
  const auto start = std::chrono::steady_clock::now();
  ShadowProxy proxy = make_shadow_proxy(scene.meshes[mesh], share);
  const double seconds = seconds_since(start);
  const std::size_t triangles = proxy.mesh.triangles.size();
  for (const std::size_t i : objects) scene.objects[i].shadow_mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(std::move(proxy.mesh));
  const std::vector<std::string> names = names_of(objects, scene);
  json["shadow_proxies"].push_back({{"objects", names},
                                    {"share", share},
                                    {"triangles", triangles},
                                    {"moved", proxy.moved},
                                    {"sticks_out", proxy.sticks_out},
                                    {"seconds", seconds}});
  text += fmt::format("\n  shadow of {} cast by {} triangles, moved inwards by up to {:.2g}", fmt::join(names, ", "),
                      triangles, proxy.moved);
  text += fmt::format("; sticks out by up to {:.2g}; {:.2f} s", proxy.sticks_out, seconds);
}

void add_shading_proxy(double share, const Objects& objects, std::size_t mesh, Scene& scene, OrderedJson& json,
                       std::string& text) {
  constexpr double kDegrees = 180.0 / kPi;
  const auto start = std::chrono::steady_clock::now();
  const LentNormals lent = lend_normals(scene.meshes[mesh], share);
  const double seconds = seconds_since(start);
  const std::vector<std::string> names = names_of(objects, scene);
  json["shading_proxies"].push_back({{"objects", names},
                                     {"share", share},
                                     {"triangles", lent.triangles},
                                     {"mean_turn", lent.mean_turn},
                                     {"worst_turn", lent.worst_turn},
                                     {"kept", lent.kept},
                                     {"seconds", seconds}});
  text += fmt::format("\n  normals of {} lent by {} triangles, turned by {:.1f} degrees (worst {:.0f})",
                      fmt::join(names, ", "), lent.triangles, kDegrees * lent.mean_turn, kDegrees * lent.worst_turn);
  if (lent.kept > 0) text += fmt::format("; {} vertices kept theirs", lent.kept);
  text += fmt::format("; {:.2f} s", seconds);
}

}  // namespace

void declare_proxies(CLI::App& app, ProxyWords& words) {
  app.add_option("--shadow-proxy", words.shadow,
                 "'object=share': a copy with this share of the triangles casts the object's shadow; '*' stands for "
                 "any part of a name; may be given several times");
  app.add_option("--shading-proxy", words.shading,
                 "'object=share': a smoothed copy with this share of the triangles lends the object its normals; as "
                 "--shadow-proxy");
}

Result<ProxyShares> proxy_shares(const ProxyWords& words, const Scene& scene) {
  ProxyShares shares;
  LUM_TRY(shares.shadow, shares_of(words.shadow, scene, "--shadow-proxy"));
  LUM_TRY(shares.shading, shares_of(words.shading, scene, "--shading-proxy"));
  return shares;
}

void add_proxies(const ProxyShares& shares, std::size_t mesh, Scene& scene, OrderedJson& json, std::string& text) {
  for (const auto& [share, objects] : grouped(shares.shadow, mesh, scene)) {
    if (share > 0.0) add_shadow_proxy(share, objects, mesh, scene, json, text);
  }
  const std::map<double, Objects> groups = grouped(shares.shading, mesh, scene);
  // The last group keeps the mesh; the others, those without a share among them, get copies before it changes.
  std::map<double, std::size_t> mesh_of;
  for (const auto& [share, objects] : groups) {
    const bool last = share == groups.rbegin()->first;
    mesh_of[share] = last ? mesh : scene.meshes.size();
    if (last) break;
    const Mesh copy = scene.meshes[mesh];
    scene.meshes.push_back(copy);
    for (const std::size_t i : objects) scene.objects[i].mesh = static_cast<int>(mesh_of[share]);
  }
  for (const auto& [share, objects] : groups) {
    if (share > 0.0) add_shading_proxy(share, objects, mesh_of[share], scene, json, text);
  }
}

}  // namespace luminist
