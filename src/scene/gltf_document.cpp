#include "scene/gltf_document.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {
namespace {

constexpr std::size_t kMostElements = std::size_t{1} << 26U;

/// The parser recurses into extras, so nesting is bounded before it starts.
bool nests_too_deep(std::string_view json) {
  constexpr int kDeepest = 128;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth > kDeepest) return true;
  }
  return false;
}

bool is_binary(std::string_view bytes) {
  return bytes.substr(0, 4) == "glTF";
}

/// The JSON of a .gltf, or of a .glb as far as it is there.
std::string_view json_of(std::string_view bytes) {
  if (!is_binary(bytes)) return bytes;
  if (bytes.size() < 20) return {};
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof(length));
  return bytes.substr(20, length);
}

/// What the parser may read: files beside the scene, nothing else.
struct FileAccess {
  std::string path;
  std::optional<Error> refused, missing;
};

bool file_exists(const std::string& name, void* user) {
  auto* access = static_cast<FileAccess*>(user);
  const auto resolved = resolve_beside(access->path, name);
  if (resolved) return true;
  auto& kept = resolved.error().kind == ErrorKind::kMissing ? access->missing : access->refused;
  if (!kept) kept = resolved.error();
  return false;
}

std::string same_path(const std::string& name, void*) {
  return name;
}

bool read_whole_file(std::vector<unsigned char>* out, std::string* error, const std::string& name, void* user) {
  auto* access = static_cast<FileAccess*>(user);
  const auto resolved = resolve_beside(access->path, name);
  const auto bytes = resolved ? read_file(*resolved) : Result<std::string>(resolved.error());
  if (!bytes) {
    access->refused = bytes.error();
    *error = bytes.error().what;
    return false;
  }
  out->assign(bytes->begin(), bytes->end());
  return true;
}

bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
  return false;
}

/// Keeps an image from a URI encoded. One in a buffer view is looked up later: its bounds are not checked yet.
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                  int size, void*) {
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

Error parse_error(const std::string& path, std::string text, bool binary) {
  Error error{ErrorKind::kBadContent, "", path, "", ""};
  unsigned line = 0, column = 0;
  const std::size_t at = text.find("at line ");
  if (!binary && at != std::string::npos &&
      std::sscanf(text.c_str() + at, "at line %u, column %u", &line, &column) == 2) {
    error.where = fmt::format("{}:{}:{}", path, line, column);
  }
  text = text.substr(0, text.find('\n'));
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  error.what = "not a sound glTF file" + (text.empty() ? "" : ": " + text);
  return error;
}

template <class T>
T load_as(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));
  return value;
}

/// One stored component as a number; integers divided by their largest value if they are normalized.
double component(const unsigned char* at, int type, bool normalized) {
  const auto scaled = [&](auto value) {
    using T = decltype(value);
    const double number = value;
    return normalized ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : number;
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return scaled(load_as<std::int8_t>(at));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return scaled(load_as<std::uint8_t>(at));
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return scaled(load_as<std::int16_t>(at));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return scaled(load_as<std::uint16_t>(at));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load_as<std::uint32_t>(at);
    default:
      return static_cast<double>(load_as<float>(at));
  }
}

/// Evenly spaced elements inside a buffer view; view -1 means zeros.
struct Elements {
  int view = -1;
  std::size_t offset = 0;
  std::size_t count = 0;
  std::size_t components = 1;
  int type = 0;  ///< of a component
  bool normalized = false;
};

/// Hands every component, as a number, to sink(index of the element, index of the component, value).
template <class Sink>
Result<void> for_each_component(const tinygltf::Model& model, const Elements& e, const std::string& path,
                                const std::string& field, Sink sink) {
  const Error bad{ErrorKind::kBadContent, "the numbers lie outside their buffer", path, field, "export the file again"};
  const std::int32_t bytes_each = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(e.type));
  if (bytes_each <= 0 || e.type == TINYGLTF_COMPONENT_TYPE_DOUBLE || e.type == TINYGLTF_COMPONENT_TYPE_INT) return bad;
  if (e.view < 0 || e.count == 0) return {};
  LUM_TRY(const std::string_view view, gltf_view(model, e.view, path));
  const std::size_t element = e.components * static_cast<std::size_t>(bytes_each);
  const std::size_t declared = model.bufferViews[static_cast<std::size_t>(e.view)].byteStride;
  const std::size_t stride = declared == 0 ? element : declared;
  constexpr std::size_t kLargestStride = 4096;
  if (stride < element || stride > kLargestStride || e.offset > view.size()) return bad;
  if ((e.count - 1) * stride + element > view.size() - e.offset) return bad;
  const auto* start = reinterpret_cast<const unsigned char*>(view.data()) + e.offset;
  for (std::size_t i = 0; i < e.count; ++i) {
    for (std::size_t c = 0; c < e.components; ++c) {
      sink(i, c, component(start + i * stride + c * static_cast<std::size_t>(bytes_each), e.type, e.normalized));
    }
  }
  return {};
}

/// Any accessor as doubles would double the memory of large meshes; the target type is the caller's.
template <class T>
Result<std::vector<T>> read_accessor(const tinygltf::Model& model, int index, int components, const std::string& path,
                                     const std::string& field) {
  const auto bad = [&](const char* what) { return Error{ErrorKind::kBadContent, what, path, field, ""}; };
  if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) return bad("there is no such accessor");
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const std::string name = fmt::format("{}: accessors[{}]", field, index);
  if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != components) {
    return Error{ErrorKind::kBadContent, fmt::format("{} components were expected", components), path, name, ""};
  }
  if (accessor.count > kMostElements) {
    return Error{ErrorKind::kLimit, fmt::format("{} elements are more than {}", accessor.count, kMostElements), path,
                 name, ""};
  }
  const auto width = static_cast<std::size_t>(components);
  const Elements dense{accessor.bufferView,    accessor.byteOffset, accessor.count, width,
                       accessor.componentType, accessor.normalized};
  std::vector<T> values;
  // A dense accessor is checked against its buffer before memory is taken for it.
  if (accessor.bufferView >= 0) {
    LUM_TRY(const std::string_view view, gltf_view(model, accessor.bufferView, path));
    if (accessor.count > view.size()) return bad("the numbers lie outside their buffer");
  }
  values.assign(accessor.count * width, T{});
  const auto store = [&](std::size_t i, std::size_t c, double v) { values[i * width + c] = static_cast<T>(v); };
  LUM_TRY_VOID(for_each_component(model, dense, path, name, store));
  if (!accessor.sparse.isSparse) return values;

  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count || sparse.indices.byteOffset < 0 ||
      sparse.values.byteOffset < 0 || sparse.indices.bufferView < 0 || sparse.values.bufferView < 0) {
    return bad("the sparse part is senseless");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  std::vector<std::size_t> places(count);
  const Elements indices{sparse.indices.bufferView,
                         static_cast<std::size_t>(sparse.indices.byteOffset),
                         count,
                         1,
                         sparse.indices.componentType,
                         false};
  LUM_TRY_VOID(for_each_component(model, indices, path, name, [&](std::size_t i, std::size_t, double v) {
    places[i] = v >= 0.0 ? static_cast<std::size_t>(v) : kMostElements;
  }));
  if (std::any_of(places.begin(), places.end(), [&](std::size_t p) { return p >= accessor.count; })) {
    return bad("a sparse index points outside");
  }
  const Elements replaced{sparse.values.bufferView,
                          static_cast<std::size_t>(sparse.values.byteOffset),
                          count,
                          width,
                          accessor.componentType,
                          accessor.normalized};
  LUM_TRY_VOID(for_each_component(model, replaced, path, name,
                                  [&](std::size_t i, std::size_t c, double v) { store(places[i], c, v); }));
  return values;
}

}  // namespace

Result<std::unique_ptr<tinygltf::Model>> parse_gltf(const std::string& path, const std::string& bytes) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max()) {
    return Error{ErrorKind::kLimit, "a glTF file holds less than 4 GiB", path, "", ""};
  }
  const bool binary = is_binary(bytes);
  if (nests_too_deep(json_of(bytes))) return parse_error(path, "the JSON nests deeper than 128 levels", binary);
  FileAccess access{path, {}, {}};
  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(keep_encoded, nullptr);
  parser.SetFsCallbacks({file_exists, same_path, read_whole_file, write_nothing, &access});
  auto model = std::make_unique<tinygltf::Model>();
  std::string error, warning;
  bool parsed = false;
  const auto size = static_cast<unsigned>(bytes.size());
  try {
    parsed = binary ? parser.LoadBinaryFromMemory(model.get(), &error, &warning,
                                                  reinterpret_cast<const unsigned char*>(bytes.data()), size)
                    : parser.LoadASCIIFromString(model.get(), &error, &warning, bytes.data(), size, "");
  } catch (const std::bad_alloc&) {
    throw;  // not the file's fault: the command line reports it as its own kind
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (access.refused) return *access.refused;
  if (!parsed && access.missing) return *access.missing;
  if (!parsed) return parse_error(path, error, binary);
  return model;
}

Result<std::string_view> gltf_view(const tinygltf::Model& model, int view, const std::string& path) {
  const std::string field = fmt::format("bufferViews[{}]", view);
  if (view < 0 || static_cast<std::size_t>(view) >= model.bufferViews.size()) {
    return Error{ErrorKind::kBadContent, "there is no such buffer view", path, field, ""};
  }
  const tinygltf::BufferView& v = model.bufferViews[static_cast<std::size_t>(view)];
  if (v.buffer < 0 || static_cast<std::size_t>(v.buffer) >= model.buffers.size()) {
    return Error{ErrorKind::kBadContent, "there is no such buffer", path, field, ""};
  }
  const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(v.buffer)].data;
  if (v.byteOffset > data.size() || v.byteLength > data.size() - v.byteOffset) {
    return Error{ErrorKind::kBadContent, "it reaches beyond its buffer", path, field, ""};
  }
  return std::string_view(reinterpret_cast<const char*>(data.data()) + v.byteOffset, v.byteLength);
}

Result<std::vector<float>> gltf_floats(const tinygltf::Model& model, int accessor, int components,
                                       const std::string& path, const std::string& field) {
  return read_accessor<float>(model, accessor, components, path, field);
}

Result<std::vector<std::uint32_t>> gltf_indices(const tinygltf::Model& model, int accessor, const std::string& path,
                                                const std::string& field) {
  if (accessor >= 0 && static_cast<std::size_t>(accessor) < model.accessors.size()) {
    const int type = model.accessors[static_cast<std::size_t>(accessor)].componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
      return Error{ErrorKind::kBadContent, "indices must be unsigned integers", path, field, ""};
    }
  }
  return read_accessor<std::uint32_t>(model, accessor, 1, path, field);
}

}  // namespace luminist
