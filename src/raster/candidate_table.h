#pragma once
// raster/candidate_table.h -- candidates as the relight program reads them: lists of blocks and who uses which. No GL.
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "raster/link_table.h"
#include "raster/shader_library.h"
#include "render/renderer.h"
#include "scene/material_params.h"

namespace luminist {

/// The lights of a candidate's rig that are shaded, by their places: muted ones are left out.
std::vector<int> lit_lights(const Candidate& candidate);

/// Equal neighbouring blocks are stored once: the candidates of a solve differ in one light or none.
class CandidateTable {
 public:
  using Row = std::array<std::uint32_t, 4>;
  /// The column of the visibility buffer of a light of the candidate's rig, or kNone for no shadows.
  using ColumnOf = std::function<std::uint32_t(const LightRig& rig, int light)>;

  /// types must outlive the table. object_names as SurfaceBuffer has them.
  CandidateTable(const RelightLayout& layout, const LightTypes& types, std::vector<std::string> object_names);

  void clear();
  /// False, and nothing is added, if the candidate's blocks do not fit beside those that are there.
  /// Muted lights are left out; the term of a muted light is black.
  [[nodiscard]] bool add(const Candidate& candidate, const ColumnOf& column_of);
  /// The same for any lights of a state (places in the rig, none muted); `whole`: with emission and ambient.
  [[nodiscard]] bool add(const ParamState& state, std::span<const int> lights, bool whole, const ColumnOf& column_of);

  [[nodiscard]] std::size_t size() const { return candidates_.size() / 2; }
  /// Two rows a candidate: see shaders/lib/host.glsl.
  [[nodiscard]] const std::vector<Row>& candidates() const { return candidates_; }
  /// Of the candidates that turn some: all of a scene's up to the last that is turned.
  [[nodiscard]] const std::vector<MaterialTurn>& materials() const { return materials_; }
  [[nodiscard]] const std::vector<Row>& lights() const { return lights_; }
  [[nodiscard]] const LinkTable& links() const { return links_; }
  [[nodiscard]] std::span<const std::byte> ambient() const { return ambient_.bytes; }
  [[nodiscard]] std::span<const std::byte> style() const { return style_.bytes; }
  [[nodiscard]] std::span<const std::byte> light_type(std::size_t type) const { return light_types_[type].bytes; }

 private:
  /// The blocks of one array so far, and the block that each user (a light by its place in the rig) had last.
  struct Blocks {
    BlockArray array;
    std::vector<std::byte> bytes;
    std::vector<std::uint32_t> last;
    [[nodiscard]] std::size_t free() const { return array.capacity - bytes.size() / array.stride; }
    std::uint32_t add(std::size_t user, std::span<const std::byte> block);
  };
  /// Where a candidate's materials are, and how many; neighbours with equal ones share them.
  Row add_materials(const ParamState& state);
  [[nodiscard]] bool fits(const LightRig& rig, std::span<const int> lights) const;

  const LightTypes* types_;
  std::vector<Row> candidates_;
  std::vector<Row> lights_;
  std::vector<MaterialTurn> materials_;
  std::string material_bytes_;  ///< of the last candidate
  Row material_row_{};          ///< and what came of them
  LinkTable links_;
  Blocks ambient_;
  Blocks style_;
  std::vector<Blocks> light_types_;
};

}  // namespace luminist
