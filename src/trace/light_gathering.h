#pragma once
// trace/light_gathering.h -- what one light of the rig adds to kept paths.
#include <cstddef>
#include <cstdint>
#include <span>

#include "rays/ray_scene.h"
#include "trace/light_paths.h"
#include "trace/rig_light.h"

namespace luminist {

/// Adds to sums [count], for paths first .. first + count of `paths`, what the light adds to each of them, its colour
/// being 1: at every vertex that scatters one point of the light is asked for, behind a shadow ray; ways that meet a
/// panel by themselves see it, and both ways of finding it are weighted (Veach 1997). Panels block nothing.
/// later: empty, or [count], to which the part is added that arrives by way of a second surface; a mirror's ways are
/// those of the eye.
/// returns the number of shadow rays. Same arguments, same bits. cost about 100 ns a vertex.
std::size_t gather_light(const RayScene& rays, const LightPaths& paths, std::size_t first, std::size_t count,
                         const RigLight& light, std::span<Vec3> sums, std::span<Vec3> later = {});

}  // namespace luminist
