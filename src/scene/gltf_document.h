#pragma once
// scene/gltf_document.h -- a parsed glTF file and safe access to its buffers.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace tinygltf {
class Model;
}

namespace luminist {

/// Whether an index that a file gives, -1 for none, is one of so many.
inline bool inside(int index, std::size_t size) {
  return index >= 0 && static_cast<std::size_t>(index) < size;
}

/// Parses .gltf or .glb bytes. External files are read only from beside the file; images stay encoded: in image of a
/// tinygltf::Image if they came from a URI (empty if the file is missing), else in their buffer view.
/// errors kBadContent (with line and column where the JSON is broken), kMissing for a buffer file, kLimit from 4 GiB.
Result<std::unique_ptr<tinygltf::Model>> parse_gltf(const std::string& path, const std::string& bytes);

/// The bytes of a buffer view. errors kBadContent if it is not inside its buffer.
Result<std::string_view> gltf_view(const tinygltf::Model& model, int view, const std::string& path);

/// An accessor as floats, normalized integers mapped to [-1,1] or [0,1], sparse ones filled in. [count * components]
/// errors kBadContent naming the field: no such accessor, another number of components, bytes outside the buffer;
/// kLimit above 2^26 elements.
Result<std::vector<float>> gltf_floats(const tinygltf::Model& model, int accessor, int components,
                                       const std::string& path, const std::string& field);

/// An accessor of unsigned integers, with the same checks. What they index is not checked.
Result<std::vector<std::uint32_t>> gltf_indices(const tinygltf::Model& model, int accessor, const std::string& path,
                                                const std::string& field);

}  // namespace luminist
