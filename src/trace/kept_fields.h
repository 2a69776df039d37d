#pragma once
// trace/kept_fields.h -- what lights add to sets of pixels, kept: a light that only changes its colour costs nothing.
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "trace/path_buffer.h"

namespace luminist {

/// Pixels, and how many paths each of them is asked for. Same id, same content.
struct PixelSet {
  std::uint64_t id = 0;
  std::vector<AskedPixel> pixels;
};

/// One value per pixel of a set.
using PixelField = std::vector<Vec3>;
using SharedField = std::shared_ptr<const PixelField>;

/// Paths and fields of one camera and one choice of path options. thread: one, which works in parallel.
class KeptFields {
 public:
  /// memory_bytes: about what paths and fields may take together. The tracer must outlive it.
  KeptFields(const PathTracer& tracer, std::size_t memory_bytes);

  /// Other options than before: everything kept is dropped.
  void use(const PathOptions& options);
  /// The tracer traces other paths from now on: everything kept is dropped.
  void drop();
  /// How many of `paths` paths may be asked for in each pixel of a whole picture: all, or what memory allows, at least
  /// one.
  [[nodiscard]] int picture_paths(int paths) const;

  /// What each light adds to the set's pixels, its colour being 1; made in one parallel pass where it is not kept.
  std::vector<SharedField> of_lights(const PixelSet& set, std::span<const RigLight> lights);
  struct Base {
    PixelField emitted;
    PixelField escaped;
  };
  std::shared_ptr<const Base> base(const PixelSet& set);

  [[nodiscard]] double shades() const { return shades_; }    ///< lights along paths
  [[nodiscard]] double queries() const { return queries_; }  ///< shadow rays

 private:
  struct Entry {
    std::string key;
    SharedField field;
  };
  const PathBuffer& buffer_with(const PixelSet& set);
  void make(const PixelSet& set, std::span<const RigLight> lights, std::span<PixelField> fields);
  void keep(std::string key, SharedField field);

  const PathTracer* tracer_;
  std::size_t memory_bytes_;
  PathOptions options_;
  std::optional<PathBuffer> paths_;
  std::unordered_map<std::uint64_t, std::shared_ptr<const Base>> bases_;
  std::list<Entry> entries_;  ///< the latest first
  std::unordered_map<std::string, std::list<Entry>::iterator> index_;
  std::size_t held_values_ = 0;
  double shades_ = 0.0;
  double queries_ = 0.0;
};

}  // namespace luminist
