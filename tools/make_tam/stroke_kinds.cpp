#include <array>

#include "base/files.h"
#include "make_tam/tonal_art_map.h"

namespace luminist {

Result<StrokeKind> stroke_kind(const std::string& name) {
  StrokeKind pencil{.name = "pencil",
                    .width = 4.2,
                    .shortest = 70.0,
                    .longest = 170.0,
                    .turn = 0.035,
                    .wobble = 1.2,
                    .taper = 0.3,
                    .swelling = 0.3,
                    .grain = 0.16,
                    .crossing_from = 0.55,
                    .crossing_angle = 1.0};
  StrokeKind ink{.name = "ink",
                 .width = 3.6,
                 .shortest = 110.0,
                 .longest = 260.0,
                 .turn = 0.02,
                 .wobble = 1.4,
                 .taper = 0.25,
                 .swelling = 0.12,
                 .crossing_from = 0.38,
                 .crossing_angle = 1.35};
  StrokeKind stipple{.name = "stipple",
                     .width = 6.5,
                     .shortest = 0.0,
                     .longest = 0.0,
                     .swelling = 0.3,
                     .crossing_from = 2.0,
                     .candidates = 120};
  const std::array<StrokeKind, 3> kinds{pencil, ink, stipple};
  std::vector<std::string> names;
  for (const StrokeKind& kind : kinds) {
    if (kind.name == name) return kind;
    names.push_back(kind.name);
  }
  const std::string near = nearest_name(name, names);
  return Error{ErrorKind::kUsage, "there is no kind of stroke '" + name + "'", "", "KIND",
               near.empty() ? "there are pencil, ink and stipple" : "did you mean '" + near + "'?"};
}

}  // namespace luminist
