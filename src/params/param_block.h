#pragma once
// params/param_block.h -- the values of one schema, one lock per degree of freedom. The bytes are the value.
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/math.h"
#include "params/param_schema.h"

namespace luminist {

/// A direction as blocks store it: the vector itself where its length is 1 up to rounding (so that a stored one keeps
/// its bits), otherwise normalized; nothing for a zero or non-finite vector.
std::optional<Vec3> unit_direction(const Vec3& vector);

/// Where a number may be, in stored units.
struct ParamRange {
  double low = 0.0;
  double high = 1.0;
};

class ParamBlock {
 public:
  /// Defaults of the schema; lengths scaled by the frame. Degrees of freedom are unlocked where the schema says solve.
  /// The schema is not null.
  ParamBlock(std::shared_ptr<const ParamSchema> schema, const SceneFrame& frame);

  [[nodiscard]] const ParamSchema& schema() const { return *schema_; }
  [[nodiscard]] const std::shared_ptr<const ParamSchema>& schema_pointer() const { return schema_; }

  /// The std140 struct, ready for a uniform or storage buffer. [schema().byte_size()]
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

  /// One stored number (float precision; int, bool and choice as their number).
  [[nodiscard]] double get(int param, int component = 0) const;
  /// Rounds for an int; a bool is true unless 0. A choice's index must exist (LUM_CHECK).
  void set(int param, int component, double value);
  [[nodiscard]] float scalar(int param) const { return static_cast<float>(get(param)); }
  [[nodiscard]] Vec2 vec2(int param) const;
  [[nodiscard]] Vec3 vec3(int param) const;
  /// Stores the three numbers as they are; whoever sets a direction gives a unit vector.
  void set_vec3(int param, const Vec3& value);

  /// Whether a parameter has the schema's default, whose lengths are scaled by the frame.
  [[nodiscard]] bool at_default(int param, const SceneFrame& frame) const;

  /// Whether it is no degree of freedom at present: locked by hand, or following another block.
  [[nodiscard]] bool locked(int dof) const { return locked_by_hand(dof) || following(dof); }
  [[nodiscard]] bool locked_by_hand(int dof) const { return locked_[static_cast<std::size_t>(dof)]; }
  [[nodiscard]] bool following(int dof) const { return following_[static_cast<std::size_t>(dof)]; }
  [[nodiscard]] int locks() const;  ///< how many are locked by hand
  void set_locked(int dof, bool locked) { locked_[static_cast<std::size_t>(dof)] = locked; }
  /// Locks or unlocks every degree of freedom of one parameter, or of all with param < 0.
  void set_param_locked(int param, bool locked);
  /// The same for what follows; only who makes it follow says so. It comes from the rig's constraints and is in no
  /// file.
  void set_param_following(int param, bool following);

  /// Where a number may be: the schema's range, which is soft, or the limits that hold of this block. Of no direction.
  [[nodiscard]] ParamRange range(int param, int component, const SceneFrame& frame) const;
  /// Limits in place of the schema's range. They come from the rig's constraints and are in no file; whoever turns the
  /// block keeps them.
  void set_limits(int dof, const ParamRange& limits);
  void clear_limits() { limits_.clear(); }
  [[nodiscard]] const ParamRange* limits(int dof) const;  ///< null: none

  /// Same schema, same bytes; locks do not count.
  [[nodiscard]] bool same_values(const ParamBlock& other) const;

 private:
  std::shared_ptr<const ParamSchema> schema_;
  std::vector<std::byte> bytes_;
  std::vector<bool> locked_;                        ///< by hand
  std::vector<bool> following_;                     ///< set from elsewhere
  std::vector<std::pair<int, ParamRange>> limits_;  ///< by degree of freedom
};

}  // namespace luminist
