#pragma once
// image_io/image_io.h -- reading and writing image files. The work is done in a helper process (luminist-image),
// because OpenImageIO loads hundreds of libraries and some hostile files abort it; this header is all that others see.
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "base/result.h"

namespace luminist {

/// What the numbers of a file mean. kAuto: 8- and 16-bit integer files are sRGB, float files linear.
enum class Encoding { kAuto, kLinear, kSrgb };

/// Reads EXR, PNG, JPEG, TIFF, HDR... as linear floats with the file's channels (grey 1, RGB 3, RGBA 4 ...).
/// errors kMissing; kBadContent for files that are not what they say; kLimit for sides above 32,768 or more than 2^27
/// values, refused from the header; kChild if the helper dies or takes more than a minute.
Result<Image> read_image(const std::string& path, Encoding encoding = Encoding::kAuto);

/// One of many images: a file, or bytes in memory if there are any (then name is for messages).
struct ImageSource {
  std::string name;
  std::string_view bytes;
  Encoding encoding = Encoding::kAuto;
};

/// Reads many images in one run of the helper. [sources.size()] results, each with its own error; an image that kills
/// the helper does not spoil the others.
std::vector<Result<Image>> read_images(std::span<const ImageSource> sources);

/// The same from bytes in memory (an image inside a .glb); name is for messages.
Result<Image> decode_image(std::string_view bytes, const std::string& name, Encoding encoding);

/// A text that write_image() stored with a picture; empty if it has none of that name.
struct StoredAttribute {
  std::string value;
  int width = 0;
  int height = 0;
};
/// Reads the whole file, so that a damaged one is found out. name begins with "luminist:". errors those of
/// read_image().
Result<StoredAttribute> read_attribute(const std::string& path, const std::string& name);

/// Writes by extension: .exr half float, linear, ZIP; .png 8-bit sRGB (clamped). Atomic as write_file_atomic().
/// attributes are stored as text metadata. errors kUnwritable, kUsage for an unknown extension, kChild.
Result<void> write_image(const std::string& path, const Image& image,
                         const std::map<std::string, std::string>& attributes = {});

/// One of many images to be written.
struct ImageFile {
  std::string path;
  const Image* image = nullptr;  ///< outlives the call
  std::map<std::string, std::string> attributes = {};
};

/// Writes many images in one run of the helper. errors the first, before anything is written where the name or the size
/// is wrong.
Result<void> write_images(std::span<const ImageFile> files);

/// 8-bit PNG in memory. errors kChild.
Result<std::string> encode_png(const Image& image, Encoding encoding);

}  // namespace luminist
