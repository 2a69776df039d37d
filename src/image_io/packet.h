#pragma once
// image_io/packet.h -- what goes between the library and its helper: one header, a text, then bytes, both ways.
#include <cstddef>
#include <cstdint>

namespace luminist {

/// What the helper is asked for. It answers every packet on its standard input but the last of a run with one on its
/// output. A run has a process of its own, which is killed with its group: what a hostile file makes of it ends there,
/// unless it takes the trouble to leave the group.
enum class HelperTask : std::uint32_t {
  kDecode = 1,     ///< text: name; data: a file -> header with size; text: our attributes; samples
  kEncodeExr = 2,  ///< text: attributes; data: float samples -> a file
  kEncodePng = 3,  ///< text: attributes; data: 8-bit samples -> a file
  kEndOfRun = 4,   ///< no answer: the next packet begins another run
};
inline constexpr const char* kServeWord = "serve";  ///< the helper's argument
inline constexpr int kIdleSeconds = 60;             ///< after which it ends

enum class Sample : std::uint32_t { kByte = 1, kShort = 2, kFloat = 4 };  ///< the value is the size in bytes

/// Attributes are names and values in turn, each ended by a zero byte. Of a file only those of this prefix come back.
inline constexpr const char* kAttributePrefix = "luminist:";
inline constexpr std::size_t kMostAttributeBytes = 4096;

inline constexpr std::uint32_t kPacketMagic = 0x4d494c31;  // "1LIM"
inline constexpr int kLargestSide = 32'768;
inline constexpr int kMostChannels = 64;
inline constexpr std::uint64_t kMostValues = std::uint64_t{1} << 27U;
inline constexpr std::uint64_t kMostFileBytes = std::uint64_t{1} << 31U;
/// A file may declare this many times its own bytes: flat pictures compress about 1,000 times, bombs far more.
inline constexpr std::uint64_t kLargestRatio = 10'000;
inline constexpr unsigned kSecondsEach = 60;

/// Written as it lies in memory: both ends run on one machine.
struct PacketHeader {
  std::uint32_t magic = kPacketMagic;
  std::uint32_t status = 0;  ///< questions: a HelperTask; answers: 0, or an ErrorKind with its message as the text
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::int32_t channels = 0;
  Sample sample = Sample::kFloat;
  std::uint64_t text_size = 0;
  std::uint64_t data_size = 0;
};
static_assert(sizeof(PacketHeader) == 40, "no padding");

/// Whether an image of this size may be held. Called by both ends before anything is allocated.
inline bool size_is_allowed(std::int64_t width, std::int64_t height, std::int64_t channels) {
  return width >= 1 && width <= kLargestSide && height >= 1 && height <= kLargestSide && channels >= 1 &&
         channels <= kMostChannels && static_cast<std::uint64_t>(width * height * channels) <= kMostValues;
}

}  // namespace luminist
