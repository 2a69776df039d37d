#include <tiny_obj_loader.h>

#include <algorithm>
#include <exception>
#include <istream>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/files.h"
#include "scene/face_faults.h"
#include "scene/mesh_repair.h"
#include "scene/obj_lines.h"
#include "scene/obj_materials.h"
#include "scene/polygon.h"
#include "scene/readers.h"
#include "scene/triple_index.h"

namespace luminist {
namespace {

/// What one object and one material have in common.
struct Part {
  std::string name;
  int material = 0;
  Mesh mesh;
  TripleIndex corners;
  bool has_normals = true;  ///< every corner has one
  bool has_uvs = false;     ///< some corner has one
};

/// The parser does not say when a coordinate is missing or no number (it reads 0), so the line is asked.
bool has_three_numbers(std::string_view line) {
  int numbers = 0;
  std::size_t at = line.find('v') + 1;
  while (numbers < 3) {
    at = line.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos) return false;
    const std::size_t end = std::min(line.find_first_of(" \t\r\n", at), line.size());
    if (line.substr(at, end - at).find_first_not_of("0123456789+-.eE") != std::string_view::npos) return false;
    at = end;
    ++numbers;
  }
  return true;
}

/// Receives the parser's calls, line by line, and builds the parts.
class ObjBuilder {
 public:
  ObjBuilder(std::string path, std::string text) : path_(std::move(path)), lines_(std::move(text)) {}
  Result<Scene> build(Diagnostics& diagnostics);

 private:
  /// Called by the parser for every mtllib.
  class Library : public tinyobj::MaterialReader {
   public:
    explicit Library(ObjBuilder& builder) : builder_(&builder) {}
    bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>*, std::string*,
                    std::string*) override {
      builder_->add_libraries();
      return true;  // so that the parser does not go on to the next word of the line
    }

   private:
    ObjBuilder* builder_;
  };

  [[nodiscard]] std::string here() const { return fmt::format("{}:{}", path_, lines_.number()); }
  void add_vertex(const Vec3& p);
  void add_face(const tinyobj::index_t* corners, std::size_t count);
  void add_libraries();
  bool add_library(const std::string& name);
  /// 0-based, or nothing where the file's index (1-based, negative from the end) points outside.
  static std::optional<std::uint32_t> resolve(int index, std::size_t size);
  bool resolve_corner(const tinyobj::index_t& corner, TripleIndex::Triple& out);
  Part& part();
  std::uint32_t add_corner(Part& part, const TripleIndex::Triple& corner);
  int material_index(const std::string& name);
  Result<Scene> finish(Diagnostics& diagnostics);

  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::string path_;
  ObjLines lines_;
  std::vector<Vec3> positions_, normals_;
  std::vector<Vec2> uvs_;
  std::string object_name_, material_name_;
  std::map<std::string, ObjMaterial> library_;
  std::vector<std::pair<std::string, ObjMaterial>> used_;
  std::vector<Part> parts_;
  std::map<std::pair<std::string, int>, std::size_t> part_of_;
  Part* part_ = nullptr;  ///< of the present object and material; found again after a change
  FaceFaults outside_{"an index points to nothing"};
  FaceFaults not_finite_{"a corner is not a finite number"};
  FaceFaults too_small_{"fewer than three corners"};
  std::vector<std::pair<std::string, std::string>> missing_libraries_;
  std::optional<Error> error_;
};

void ObjBuilder::add_vertex(const Vec3& p) {
  positions_.push_back(has_three_numbers(lines_.line()) ? p : Vec3(std::numeric_limits<float>::quiet_NaN()));
}

/// The words of an mtllib line are file names, but many writers put one name with spaces there.
void ObjBuilder::add_libraries() {
  std::string names(lines_.line());
  names = trimmed(names.substr(names.find("mtllib") + 6));
  if (add_library(names)) return;
  std::size_t missing = 0;
  std::istringstream words(names);
  for (std::string name; words >> name;) missing += add_library(name) ? 0 : 1;
  if (missing > 0)
    missing_libraries_.emplace_back(here(), fmt::format("the material library \"{}\" is not there", names));
}

/// Returns false if there is no such file.
bool ObjBuilder::add_library(const std::string& name) {
  const Result<void> read = read_mtl(path_, name, library_);
  if (read) return true;
  if (read.error().kind == ErrorKind::kMissing) return false;
  if (!error_) error_ = read.error(), error_->where = here();
  return true;
}

std::optional<std::uint32_t> ObjBuilder::resolve(int index, std::size_t size) {
  const auto count = static_cast<std::int64_t>(size);
  const std::int64_t zero_based = index > 0 ? std::int64_t{index} - 1 : count + index;
  if (index == 0 || zero_based < 0 || zero_based >= count) return std::nullopt;
  return static_cast<std::uint32_t>(zero_based);
}

bool ObjBuilder::resolve_corner(const tinyobj::index_t& corner, TripleIndex::Triple& out) {
  const auto vertex = resolve(corner.vertex_index, positions_.size());
  const auto uv = resolve(corner.texcoord_index, uvs_.size());
  const auto normal = resolve(corner.normal_index, normals_.size());
  const bool uv_outside = corner.texcoord_index != 0 && !uv;
  const bool normal_outside = corner.normal_index != 0 && !normal;
  if (!vertex || uv_outside || normal_outside) {
    outside_.add(here(),
                 fmt::format("corner {}/{}/{}", corner.vertex_index, corner.texcoord_index, corner.normal_index));
    return false;
  }
  if (!is_usable(positions_[*vertex])) {
    not_finite_.add(here(), fmt::format("vertex {}", *vertex + 1));
    return false;
  }
  out = {*vertex, uv.value_or(kNone), normal.value_or(kNone)};
  return true;
}

int ObjBuilder::material_index(const std::string& name) {
  const auto same = [&](const auto& entry) { return entry.first == name; };
  const auto found = std::find_if(used_.begin(), used_.end(), same);
  if (found != used_.end()) return static_cast<int>(found - used_.begin());
  const auto known = library_.find(name);
  used_.emplace_back(name, known != library_.end() ? known->second : ObjMaterial{});
  used_.back().second.material.name = name.empty() ? "default" : name;
  return static_cast<int>(used_.size()) - 1;
}

Part& ObjBuilder::part() {
  if (part_ == nullptr) {
    const int material = material_index(material_name_);
    const auto [entry, is_new] = part_of_.try_emplace({object_name_, material}, parts_.size());
    if (is_new) {
      parts_.emplace_back();
      parts_.back().name = object_name_;
      parts_.back().material = material;
    }
    part_ = &parts_[entry->second];
  }
  return *part_;
}

std::uint32_t ObjBuilder::add_corner(Part& part, const TripleIndex::Triple& corner) {
  const std::size_t known = part.corners.size();
  const std::uint32_t index = part.corners.add(corner);
  if (part.corners.size() > known) {
    const auto [vertex, uv, normal] = corner;
    part.mesh.positions.push_back(positions_[vertex]);
    part.mesh.uvs.push_back(uv == kNone ? Vec2(0.0F) : uvs_[uv]);
    part.mesh.normals.push_back(normal == kNone ? Vec3(0.0F) : normals_[normal]);
    part.has_uvs |= uv != kNone;
    part.has_normals &= normal != kNone;
  }
  return index;
}

void ObjBuilder::add_face(const tinyobj::index_t* corners, std::size_t count) {
  if (count < 3) return too_small_.add(here(), fmt::format("{} corners", count));
  std::vector<TripleIndex::Triple> resolved(count);
  std::vector<Vec3> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!resolve_corner(corners[i], resolved[i])) return;
    points[i] = positions_[resolved[i][0]];
  }
  Part& target = part();
  std::vector<std::uint32_t> index(count);
  for (std::size_t i = 0; i < count; ++i) index[i] = add_corner(target, resolved[i]);
  for (const auto& t : triangulate(points)) target.mesh.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
}

Result<Scene> ObjBuilder::build(Diagnostics& diagnostics) {
  tinyobj::callback_t calls;
  calls.vertex_cb = [](void* user, float x, float y, float z, float) {
    static_cast<ObjBuilder*>(user)->add_vertex({x, y, z});
  };
  calls.normal_cb = [](void* user, float x, float y, float z) {
    static_cast<ObjBuilder*>(user)->normals_.emplace_back(x, y, z);
  };
  calls.texcoord_cb = [](void* user, float u, float v, float) {
    static_cast<ObjBuilder*>(user)->uvs_.emplace_back(u, 1.0F - v);
  };
  calls.index_cb = [](void* user, tinyobj::index_t* corners, int count) {
    static_cast<ObjBuilder*>(user)->add_face(corners, static_cast<std::size_t>(count));
  };
  calls.usemtl_cb = [](void* user, const char* name, int) {
    auto* builder = static_cast<ObjBuilder*>(user);
    builder->material_name_ = trimmed(name), builder->part_ = nullptr;
  };
  calls.group_cb = [](void* user, const char** names, int count) {
    auto* builder = static_cast<ObjBuilder*>(user);
    builder->object_name_ = count > 0 ? trimmed(names[0]) : "", builder->part_ = nullptr;
  };
  calls.object_cb = [](void* user, const char* name) {
    auto* builder = static_cast<ObjBuilder*>(user);
    builder->object_name_ = trimmed(name), builder->part_ = nullptr;
  };
  std::istream stream(&lines_);
  Library library(*this);
  std::string warnings, errors;
  if (!tinyobj::LoadObjWithCallback(stream, calls, this, &library, &warnings, &errors)) {
    return Error{ErrorKind::kBadContent, errors.empty() ? "not an OBJ file" : errors, here(), "", ""};
  }
  return finish(diagnostics);
}

Result<Scene> ObjBuilder::finish(Diagnostics& diagnostics) {
  if (error_) return *error_;
  for (const auto& [where, what] : missing_libraries_) diagnostics.warn(where, what);
  for (const FaceFaults* faults : {&outside_, &not_finite_, &too_small_}) faults->report(diagnostics);
  Scene scene;
  for (Part& part : parts_) {
    if (part.mesh.triangles.empty()) continue;
    if (!part.has_normals) part.mesh.normals.clear();
    if (!part.has_uvs) part.mesh.uvs.clear();
    Object object;
    object.name = part.name;
    object.mesh = static_cast<int>(scene.meshes.size());
    object.material = part.material;
    scene.meshes.push_back(std::move(part.mesh));
    scene.objects.push_back(std::move(object));
  }
  std::vector<ObjMaterial> used;
  for (auto& entry : used_) used.push_back(std::move(entry.second));
  LUM_TRY_VOID(add_obj_materials(path_, used, scene, diagnostics));
  return scene;
}

}  // namespace

Result<Scene> read_obj(const std::string& path, Diagnostics& diagnostics) {
  LUM_TRY(std::string text, read_file(path));
  try {
    return ObjBuilder(path, std::move(text)).build(diagnostics);
  } catch (const std::bad_alloc&) {
    throw;  // not the file's fault: the command line reports it as its own kind
  } catch (const std::exception& e) {
    return Error{ErrorKind::kBadContent, fmt::format("the OBJ parser gave up: {}", e.what()), path, "", ""};
  }
}

}  // namespace luminist
