#pragma once
// params/param_block.h -- the values of one schema, one lock per degree of freedom. The bytes are the value.
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/math.h"
#include "params/param_schema.h"

namespace luminist {

class ParamBlock {
 public:
  /// Defaults of the schema; lengths scaled by the frame. Degrees of freedom are unlocked where the schema says solve.
  ParamBlock(std::shared_ptr<const ParamSchema> schema, const SceneFrame& frame);

  [[nodiscard]] const ParamSchema& schema() const { return *schema_; }
  [[nodiscard]] const std::shared_ptr<const ParamSchema>& schema_pointer() const { return schema_; }

  /// The std140 struct, ready for a uniform or storage buffer. [schema().byte_size()]
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

  /// One stored number (float precision; int, bool and choice as their number).
  [[nodiscard]] double get(int param, int component = 0) const;
  void set(int param, int component, double value);
  [[nodiscard]] float scalar(int param) const { return static_cast<float>(get(param)); }
  [[nodiscard]] Vec2 vec2(int param) const;
  [[nodiscard]] Vec3 vec3(int param) const;
  void set_vec3(int param, const Vec3& value);

  [[nodiscard]] bool locked(int dof) const { return locked_[static_cast<std::size_t>(dof)]; }
  void set_locked(int dof, bool locked) { locked_[static_cast<std::size_t>(dof)] = locked; }
  /// Locks or unlocks every degree of freedom of one parameter, or of all with param < 0.
  void set_param_locked(int param, bool locked);

  /// Same schema, same bytes; locks do not count.
  [[nodiscard]] bool same_values(const ParamBlock& other) const;

 private:
  std::shared_ptr<const ParamSchema> schema_;
  std::vector<std::byte> bytes_;
  std::vector<bool> locked_;
};

}  // namespace luminist
