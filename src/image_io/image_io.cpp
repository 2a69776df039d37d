#include "image_io/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"
#include "image_io/dialogue.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

Error error_of(const Answer& answer, const std::string& name) {
  constexpr std::array kKinds{ErrorKind::kBadContent, ErrorKind::kLimit, ErrorKind::kChild};
  const auto kind = static_cast<ErrorKind>(answer.header.status);
  const bool known = std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
  std::string what = answer.text;
  std::replace(what.begin(), what.end(), '\n', ' ');
  return {known ? kind : ErrorKind::kChild, std::move(what), name, "", ""};
}

/// Stored numbers to linear floats, by a table for integers.
template <class Integer>
void convert(const std::string& data, int channels, bool srgb, std::vector<float>& out) {
  constexpr std::size_t kValues = std::size_t{1} << (8 * sizeof(Integer));
  std::vector<float> color(kValues), plain(kValues);
  for (std::size_t i = 0; i < kValues; ++i) {
    plain[i] = static_cast<float>(i) / static_cast<float>(kValues - 1);
    color[i] = srgb ? linear_from_srgb(plain[i]) : plain[i];
  }
  const auto count = static_cast<std::size_t>(channels);
  const std::size_t alpha = count == 2 || count == 4 ? count - 1 : count;  // alpha is never encoded
  for (std::size_t i = 0; i < out.size(); ++i) {
    Integer value = 0;
    std::memcpy(&value, &data[i * sizeof(Integer)], sizeof(Integer));
    out[i] = (i % count == alpha ? plain : color)[value];
  }
}

Result<Image> image_from(const Answer& answer, const ImageSource& source) {
  const PacketHeader& h = answer.header;
  if (h.status != 0) return error_of(answer, source.name);
  const bool known = h.sample == Sample::kByte || h.sample == Sample::kShort || h.sample == Sample::kFloat;
  const bool allowed = known && size_is_allowed(h.width, h.height, h.channels);
  const std::uint64_t values = !allowed ? 0
                                        : static_cast<std::uint64_t>(h.width) * static_cast<std::uint64_t>(h.height) *
                                              static_cast<std::uint64_t>(h.channels);
  if (!allowed || h.data_size != values * static_cast<std::uint64_t>(h.sample)) {
    return Error{ErrorKind::kChild, "the image helper gave a senseless answer", source.name, "", ""};
  }
  Image image(h.width, h.height, h.channels);
  if (h.sample == Sample::kByte)
    convert<std::uint8_t>(answer.data, h.channels, source.encoding != Encoding::kLinear, image.data);
  if (h.sample == Sample::kShort)
    convert<std::uint16_t>(answer.data, h.channels, source.encoding != Encoding::kLinear, image.data);
  if (h.sample == Sample::kFloat) {
    std::memcpy(image.data.data(), answer.data.data(), answer.data.size());
    if (source.encoding == Encoding::kSrgb) {
      for (float& v : image.data) v = linear_from_srgb(v);
    }
  }
  return image;
}

Error helper_died(const ProcessEnd& end, const std::string& name) {
  return {ErrorKind::kChild, "the image helper " + end.description(), name, "", "the image is damaged or too complex"};
}

/// Asks for the images from `first` on and stores what comes; returns the first image without a result.
std::size_t read_run(std::span<const ImageSource> sources, std::span<Question> questions,
                     const std::vector<std::size_t>& order, std::size_t first, std::vector<Result<Image>>& results) {
  Result<Dialogue> dialogue = ask_helper(questions.subspan(first));
  if (!dialogue) {
    for (; first < order.size(); ++first) results[order[first]] = dialogue.error();
    return first;
  }
  for (const Answer& answer : dialogue->answers) {
    if (first == order.size()) break;
    results[order[first]] = image_from(answer, sources[order[first]]);
    ++first;
  }
  if (first < order.size()) {
    results[order[first]] = helper_died(dialogue->end, sources[order[first]].name);
    ++first;
  }
  return first;
}

std::string encoded_bytes(const Image& image, bool srgb) {
  std::string bytes(image.data.size(), '\0');
  const auto count = static_cast<std::size_t>(image.channels);
  const std::size_t alpha = count == 2 || count == 4 ? count - 1 : count;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const float value = std::isnan(image.data[i]) ? 0.0F : std::clamp(image.data[i], 0.0F, 1.0F);
    const float stored = srgb && i % count != alpha ? srgb_from_linear(value) : value;
    bytes[i] = static_cast<char>(static_cast<unsigned char>(std::lround(255.0F * stored)));
  }
  return bytes;
}

/// An image that is to become a file.
struct Encodable {
  HelperTask task;  ///< kEncodeExr, kEncodePng
  const Image* image;
  std::string name;     ///< for messages
  std::string text;     ///< attributes as the helper reads them
  std::string encoded;  ///< samples of a PNG; those of an EXR are the image's own

  [[nodiscard]] std::string_view samples() const {
    if (task != HelperTask::kEncodeExr) return encoded;
    return {reinterpret_cast<const char*>(image->data.data()), image->data.size() * sizeof(float)};
  }
};

Result<Encodable> encodable(const std::string& path, const Image& image,
                            const std::map<std::string, std::string>& attributes) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (extension != ".exr" && extension != ".png") {
    return Error{ErrorKind::kUsage, fmt::format("cannot write an image of kind \"{}\"", extension), path, "",
                 "use .exr or .png"};
  }
  if (extension == ".png" && image.channels > 4) {
    return Error{ErrorKind::kUsage, fmt::format("a PNG cannot hold {} channels", image.channels), path, "", "use .exr"};
  }
  if (!size_is_allowed(image.width, image.height, image.channels)) {
    return Error{
        ErrorKind::kLimit,
        fmt::format("{} x {} pixels of {} channels are over the limit", image.width, image.height, image.channels),
        path, "", ""};
  }
  Encodable item{extension == ".exr" ? HelperTask::kEncodeExr : HelperTask::kEncodePng, &image, path, "", ""};
  for (const auto& [key, value] : attributes) item.text += key + '\0' + value + '\0';
  if (extension == ".png") item.encoded = encoded_bytes(image, true);
  return item;
}

/// The files' bytes, from one run of the helper.
Result<std::vector<std::string>> encode(std::span<const Encodable> items) {
  std::vector<Question> questions;
  for (const Encodable& item : items) {
    Question question{item.task};
    question.header.width = item.image->width, question.header.height = item.image->height;
    question.header.channels = item.image->channels;
    question.text = item.text, question.data = item.samples();
    questions.push_back(question);
  }
  LUM_TRY(Dialogue dialogue, ask_helper(questions));
  std::vector<std::string> files;
  for (Answer& answer : dialogue.answers) {
    if (answer.header.status != 0) return error_of(answer, items[files.size()].name);
    files.push_back(std::move(answer.data));
  }
  if (files.size() < items.size()) return helper_died(dialogue.end, items[files.size()].name);
  return files;
}

}  // namespace

Result<Image> read_image(const std::string& path, Encoding encoding) {
  const ImageSource source{path, {}, encoding};
  return std::move(read_images({&source, 1}).front());
}

Result<StoredAttribute> read_attribute(const std::string& path, const std::string& name) {
  LUM_TRY(const std::string file, read_file(path));
  Question question;
  question.text = path, question.data = file;
  LUM_TRY(const Dialogue dialogue, ask_helper({&question, 1}));
  if (dialogue.answers.empty()) return helper_died(dialogue.end, path);
  const Answer& answer = dialogue.answers.front();
  LUM_TRY(const Image image, image_from(answer, {path, {}, Encoding::kLinear}));
  StoredAttribute stored{"", image.width, image.height};
  for (std::size_t at = 0; at < answer.text.size();) {
    const std::size_t middle = std::min(answer.text.find('\0', at), answer.text.size());
    const std::size_t end = std::min(answer.text.find('\0', middle + 1), answer.text.size());
    if (answer.text.compare(at, middle - at, name) == 0 && middle < answer.text.size()) {
      stored.value = answer.text.substr(middle + 1, end - middle - 1);
    }
    at = end + 1;
  }
  return stored;
}

Result<Image> decode_image(std::string_view bytes, const std::string& name, Encoding encoding) {
  if (bytes.empty()) return Error{ErrorKind::kBadContent, "the image is empty", name, "", ""};
  const ImageSource source{name, bytes, encoding};
  return std::move(read_images({&source, 1}).front());
}

std::vector<Result<Image>> read_images(std::span<const ImageSource> sources) {
  std::vector<Result<Image>> results(sources.size(), Result<Image>(Image()));
  std::vector<std::string> files(sources.size());
  std::vector<Question> questions;
  std::vector<std::size_t> order;  // question -> source
  for (std::size_t i = 0; i < sources.size(); ++i) {
    std::string_view bytes = sources[i].bytes;
    if (bytes.empty()) {
      Result<std::string> file = read_file(sources[i].name);
      if (!file) {
        results[i] = file.error();
        continue;
      }
      files[i] = std::move(*file);
      bytes = files[i];
    }
    if (bytes.size() > kMostFileBytes) {
      results[i] = Error{ErrorKind::kLimit, "the image file is too large", sources[i].name, "", ""};
      continue;
    }
    Question question;
    question.text = sources[i].name, question.data = bytes;
    questions.push_back(question);
    order.push_back(i);
  }
  for (std::size_t next = 0; next < order.size();) next = read_run(sources, questions, order, next, results);
  return results;
}

Result<void> write_image(const std::string& path, const Image& image,
                         const std::map<std::string, std::string>& attributes) {
  const ImageFile file{path, &image, attributes};
  return write_images({&file, 1});
}

Result<void> write_images(std::span<const ImageFile> files) {
  std::vector<Encodable> items;
  for (const ImageFile& file : files) {
    LUM_TRY(Encodable item, encodable(file.path, *file.image, file.attributes));
    items.push_back(std::move(item));
  }
  if (items.empty()) return {};
  LUM_TRY(const std::vector<std::string> bytes, encode(items));
  for (std::size_t i = 0; i < items.size(); ++i) LUM_TRY_VOID(write_file_atomic(items[i].name, bytes[i]));
  return {};
}

Result<std::string> encode_png(const Image& image, Encoding encoding) {
  LUM_CHECK(image.channels <= 4, "a PNG holds up to four channels");
  Encodable item{HelperTask::kEncodePng, &image, "a PNG in memory", "",
                 encoded_bytes(image, encoding != Encoding::kLinear)};
  if (!size_is_allowed(image.width, image.height, image.channels)) {
    return Error{ErrorKind::kLimit, "the image is over the limit", item.name, "", ""};
  }
  LUM_TRY(std::vector<std::string> bytes, encode({&item, 1}));
  return std::move(bytes.front());
}

}  // namespace luminist
