#pragma once
// params/param_schema.h -- what a parameter is: one [[param]] table, from which everything else follows.
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/math.h"
#include "base/result.h"

namespace luminist {

enum class ParamType { kFloat, kInt, kBool, kVec2, kVec3, kColor, kDirection, kChoice };
/// How the solver's [0,1] maps to the range. Scene: range and default are in scene radii, and a parameter whose role
/// is "position" is measured from the scene's centre; the stored value is absolute.
enum class ParamScale { kLinear, kLog, kScene };

/// "float", "vec3"...: the word of a manifest.
std::string_view type_name(ParamType type);

/// One declared parameter. Vectors hold one number per component.
struct ParamSpec {
  std::string name;  ///< a GLSL identifier of lower-case letters, digits and single underscores
  ParamType type = ParamType::kFloat;
  std::vector<double> default_value;  ///< of a direction a unit vector; of a choice its index
  std::vector<double> range_min;      ///< soft; a direction's range is in radians around its present value
  std::vector<double> range_max;
  ParamScale scale = ParamScale::kLinear;
  std::string unit;
  std::string group;
  std::string role;
  std::string doc;
  bool solve = false;                ///< unlocked when the block is made
  bool quality = false;              ///< no degree of freedom: how well a thing is computed, not what it is
  std::vector<std::string> choices;  ///< of a choice, which stores the index
  std::size_t offset = 0;            ///< bytes from the start of the std140 struct
  int first_dof = 0;                 ///< index of its first degree of freedom in the block

  [[nodiscard]] int components() const;  ///< stored numbers: 1, 2 or 3
  [[nodiscard]] int dofs() const;        ///< what the solver may turn: 2 for a direction, 0 for int, bool and choice

  /// The stored number of one that is written in the manifest's units (scene radii), and back.
  [[nodiscard]] double stored(int component, double written, const SceneFrame& frame) const;
  [[nodiscard]] double written(int component, double stored, const SceneFrame& frame) const;
};

/// A list of parameters and their place in a std140 struct.
class ParamSchema {
 public:
  /// From specs made in C++; fills offsets. errors kStyle as for parse(), with `where` as the place. A missing doc is
  /// no error here.
  static Result<std::shared_ptr<const ParamSchema>> create(std::vector<ParamSpec> specs, const std::string& where);

  /// The [[param]] tables of a TOML manifest; other tables are the caller's. Keys: name, type, default, range, doc, and
  /// where they differ from their defaults scale, unit, group, role, solve, quality, choices. `range` is [min, max] for
  /// every component, or [[min...], [max...]]; a bool and a choice have none.
  /// errors kStyle at path:line:col: unknown key (with the nearest valid one), wrong type, min not below max,
  /// non-finite or out-of-range default, a name used twice or reserved by GLSL, more than 1,000 parameters.
  static Result<std::shared_ptr<const ParamSchema>> parse(std::string_view manifest, const std::string& path);

  [[nodiscard]] const std::vector<ParamSpec>& specs() const { return specs_; }
  [[nodiscard]] const ParamSpec& operator[](int param) const { return specs_[static_cast<std::size_t>(param)]; }
  [[nodiscard]] int size() const { return static_cast<int>(specs_.size()); }
  [[nodiscard]] int dofs() const { return dofs_; }
  [[nodiscard]] std::size_t byte_size() const { return byte_size_; }  ///< multiple of 16; at least 16
  [[nodiscard]] std::optional<int> find(std::string_view name) const;
  [[nodiscard]] std::optional<int> by_role(std::string_view role) const;  ///< the first with that role
  [[nodiscard]] std::vector<std::string> names() const;

  /// "struct Cinematic {\n  vec3 position;\n ...};\n", laid out as bytes() of a ParamBlock is (std140, alone or in an
  /// array). An int and a choice are `int`, a bool is `uint` (0 or 1; read it as `flag != 0u`), a colour and a
  /// direction `vec3`. A schema without parameters gets one float named `unused`, because GLSL has no empty struct.
  [[nodiscard]] std::string glsl_struct(std::string_view type_name) const;

 private:
  std::vector<ParamSpec> specs_;
  int dofs_ = 0;
  std::size_t byte_size_ = 16;
};

}  // namespace luminist
