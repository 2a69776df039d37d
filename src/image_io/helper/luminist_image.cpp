// image_io/helper/luminist_image.cpp -- the helper process: decodes and encodes image files with OpenImageIO, which
// loads hundreds of libraries and which some hostile files abort. It sees no file but its standard input and output.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image_io/packet.h"

namespace luminist {
namespace {

struct Packet {
  PacketHeader header;
  std::string text;
  std::vector<unsigned char> data;
};

Packet failure(ErrorKind kind, std::string what) {
  Packet answer;
  answer.header.status = static_cast<std::uint32_t>(kind);
  answer.text = std::move(what);
  return answer;
}

bool read_all(void* to, std::size_t size) {
  auto* at = static_cast<unsigned char*>(to);
  while (size > 0) {
    const ssize_t got = ::read(STDIN_FILENO, at, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool write_all(int fd, const void* from, std::size_t size) {
  const auto* at = static_cast<const unsigned char*>(from);
  while (size > 0) {
    const ssize_t put = ::write(fd, at, size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    at += put, size -= static_cast<std::size_t>(put);
  }
  return true;
}

/// Reads one request; false at the end of the input.
bool receive(Packet& packet) {
  if (!read_all(&packet.header, sizeof(packet.header)) || packet.header.magic != kPacketMagic) return false;
  if (packet.header.text_size > kMostFileBytes || packet.header.data_size > kMostFileBytes) return false;
  packet.text.resize(packet.header.text_size);
  packet.data.resize(packet.header.data_size);
  return read_all(packet.text.data(), packet.text.size()) && read_all(packet.data.data(), packet.data.size());
}

bool send(Packet& packet) {
  packet.header.text_size = packet.text.size();
  packet.header.data_size = packet.data.size();
  return write_all(STDOUT_FILENO, &packet.header, sizeof(packet.header)) &&
         write_all(STDOUT_FILENO, packet.text.data(), packet.text.size()) &&
         write_all(STDOUT_FILENO, packet.data.data(), packet.data.size());
}

/// The reader for a file by its first bytes; "" for everything that is not on this list.
std::string format_of(const Packet& request) {
  using namespace std::string_view_literals;
  const std::string_view file(reinterpret_cast<const char*>(request.data.data()), request.data.size());
  constexpr std::pair<std::string_view, const char*> kMagics[] = {{"\x89PNG\r\n\x1a\n"sv, "png"},
                                                                  {"\xff\xd8\xff"sv, "jpeg"},
                                                                  {"\x76\x2f\x31\x01"sv, "openexr"},
                                                                  {"II*\0"sv, "tiff"},
                                                                  {"MM\0*"sv, "tiff"},
                                                                  {"#?RADIANCE"sv, "hdr"},
                                                                  {"#?RGBE"sv, "hdr"},
                                                                  {"BM"sv, "bmp"},
                                                                  {"GIF8"sv, "gif"}};
  for (const auto& [magic, format] : kMagics) {
    if (file.substr(0, magic.size()) == magic) return format;
  }
  if (file.substr(0, 4) == "RIFF" && file.size() > 12 && file.substr(8, 4) == "WEBP") return "webp";
  std::string extension = request.text.substr(std::min(request.text.size(), request.text.rfind('.')));
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension == ".tga" ? "targa" : "";  // the one common format without a mark at its start
}

/// A file in memory that the readers can open by a path.
class MemoryFile {
 public:
  explicit MemoryFile(const std::vector<unsigned char>& bytes) : fd_(::memfd_create("image", MFD_CLOEXEC)) {
    if (fd_ < 0 || !write_all(fd_, bytes.data(), bytes.size())) throw std::bad_alloc();
  }
  ~MemoryFile() { ::close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", fd_); }

 private:
  int fd_;
};

/// Nothing, or why the header alone is reason enough to refuse.
std::string refusal(const OIIO::ImageSpec& spec, std::size_t file_size) {
  if (spec.deep || spec.depth > 1) return "deep and volume images are not read";
  const auto allowed = [&](int width, int height) { return size_is_allowed(width, height, spec.nchannels); };
  const bool tiles_allowed = spec.tile_width == 0 || allowed(spec.tile_width, std::max(spec.tile_height, 1));
  if (!allowed(spec.width, spec.height) || !allowed(spec.full_width, spec.full_height) || !tiles_allowed) {
    return fmt::format("{} x {} pixels of {} channels are over the limit ({} a side, {} values)", spec.width,
                       spec.height, spec.nchannels, kLargestSide, kMostValues);
  }
  if (spec.image_bytes(true) / std::max<std::size_t>(file_size, 1) > kLargestRatio) {
    return fmt::format("a file of {} bytes cannot hold {} x {} pixels", file_size, spec.width, spec.height);
  }
  return {};
}

/// The data window laid into the display window (pixels between them are zero), as an artist sees it.
std::vector<unsigned char> in_display_window(std::vector<unsigned char> data, const OIIO::ImageSpec& spec,
                                             std::size_t pixel_size) {
  if (spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width &&
      spec.height == spec.full_height) {
    return data;
  }
  const auto full_width = static_cast<std::size_t>(spec.full_width);
  std::vector<unsigned char> full(full_width * static_cast<std::size_t>(spec.full_height) * pixel_size);
  const std::int64_t dx = std::int64_t{spec.x} - spec.full_x, dy = std::int64_t{spec.y} - spec.full_y;
  const std::int64_t first = std::max<std::int64_t>(0, -dx);
  const std::int64_t last = std::min<std::int64_t>(spec.width, spec.full_width - dx);
  for (std::int64_t y = 0; y < spec.height && first < last; ++y) {
    if (y + dy < 0 || y + dy >= spec.full_height) continue;
    const unsigned char* from = data.data() + static_cast<std::size_t>(y * spec.width + first) * pixel_size;
    unsigned char* to =
        full.data() +
        (static_cast<std::size_t>(y + dy) * full_width + static_cast<std::size_t>(first + dx)) * pixel_size;
    std::memcpy(to, from, static_cast<std::size_t>(last - first) * pixel_size);
  }
  return full;
}

/// Our own attributes of a file, as the other end reads them.
std::string own_attributes(const OIIO::ImageSpec& spec) {
  std::string text;
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    const std::string name = value.name().string();
    if (name.rfind(kAttributePrefix, 0) != 0 || value.type() != OIIO::TypeString) continue;
    const std::string pair = name + '\0' + value.get_string() + '\0';
    if (text.size() + pair.size() <= kMostAttributeBytes) text += pair;
  }
  return text;
}

Packet decode(const Packet& request) {
  const std::string format = format_of(request);
  if (format.empty()) return failure(ErrorKind::kBadContent, "not an image of a known kind");
  const MemoryFile file(request.data);
  const auto input = OIIO::ImageInput::create(format);
  if (!input) return failure(ErrorKind::kBadContent, "this OpenImageIO cannot read " + format);
  OIIO::ImageSpec config, spec;
  config.attribute("oiio:UnassociatedAlpha", 1);
  if (!input->open(file.path(), spec, config)) {
    return failure(ErrorKind::kBadContent, "not a sound " + format + " image: " + input->geterror());
  }
  if (std::string why = refusal(spec, request.data.size()); !why.empty())
    return failure(ErrorKind::kLimit, std::move(why));
  OIIO::TypeDesc type = spec.format;
  for (const OIIO::TypeDesc& channel : spec.channelformats) {
    if (channel != type) type = OIIO::TypeFloat;
  }
  if (type != OIIO::TypeUInt8 && type != OIIO::TypeUInt16) type = OIIO::TypeFloat;
  Packet answer;
  answer.text = own_attributes(spec);
  answer.header.sample = static_cast<Sample>(type.size());
  const std::size_t pixel_size = type.size() * static_cast<std::size_t>(spec.nchannels);
  std::vector<unsigned char> pixels(spec.image_pixels() * pixel_size);
  if (!input->read_image(0, 0, 0, spec.nchannels, type, pixels.data())) {
    return failure(ErrorKind::kBadContent, "broken " + format + " image: " + input->geterror());
  }
  answer.data = in_display_window(std::move(pixels), spec, pixel_size);
  answer.header.width = spec.full_width;
  answer.header.height = spec.full_height;
  answer.header.channels = spec.nchannels;
  return answer;
}

/// Finite values stay finite in half floats.
void clamp_to_half(std::vector<unsigned char>& data) {
  constexpr float kLargestHalf = 65504.0F;
  for (std::size_t i = 0; i + sizeof(float) <= data.size(); i += sizeof(float)) {
    float value = 0.0F;
    std::memcpy(&value, &data[i], sizeof(float));
    if (std::isfinite(value)) value = std::clamp(value, -kLargestHalf, kLargestHalf);
    std::memcpy(&data[i], &value, sizeof(float));
  }
}

void set_attributes(const std::string& text, OIIO::ImageSpec& spec) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\0', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) spec.attribute(words[i], words[i + 1]);
}

Packet encode(Packet& request, bool exr) {
  const PacketHeader& header = request.header;
  const OIIO::TypeDesc type = exr ? OIIO::TypeFloat : OIIO::TypeUInt8;
  if (!size_is_allowed(header.width, header.height, header.channels) ||
      header.data_size != static_cast<std::uint64_t>(header.width) * static_cast<std::uint64_t>(header.height) *
                              static_cast<std::uint64_t>(header.channels) * type.size()) {
    return failure(ErrorKind::kLimit, fmt::format("cannot write {} x {} pixels of {} channels", header.width,
                                                  header.height, header.channels));
  }
  OIIO::ImageSpec spec(header.width, header.height, header.channels, exr ? OIIO::TypeHalf : OIIO::TypeUInt8);
  if (header.channels == 1) spec.channelnames = {"Y"};
  if (header.channels == 2) spec.channelnames = {"Y", "A"}, spec.alpha_channel = 1;
  spec.attribute("compression", exr ? "zip" : "filter");
  spec.attribute("oiio:ColorSpace", exr ? "Linear" : "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // the same picture is the same file
  set_attributes(request.text, spec);
  if (exr) clamp_to_half(request.data);
  Packet answer;
  OIIO::Filesystem::IOVecOutput bytes(answer.data);
  const auto output = OIIO::ImageOutput::create(exr ? "openexr" : "png");
  if (!output || !output->set_ioproxy(&bytes) || !output->open(exr ? "image.exr" : "image.png", spec) ||
      !output->write_image(type, request.data.data()) || !output->close()) {
    return failure(ErrorKind::kChild, "cannot encode the image: " + (output ? output->geterror() : OIIO::geterror()));
  }
  return answer;
}

Packet answer_to(Packet& request) {
  try {
    switch (static_cast<HelperTask>(request.header.status)) {
      case HelperTask::kDecode:
        return decode(request);
      case HelperTask::kEncodeExr:
        return encode(request, true);
      case HelperTask::kEncodePng:
        return encode(request, false);
      default:
        return failure(ErrorKind::kChild, "unknown task");
    }
  } catch (const std::bad_alloc&) {
    return failure(ErrorKind::kLimit, "not enough memory for the image");
  } catch (const std::exception& e) {
    return failure(ErrorKind::kBadContent, e.what());
  }
}

/// A file that asks for too much meets std::bad_alloc, not the machine's memory.
void limit_resources() {
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
#ifndef __SANITIZE_ADDRESS__  // which reserves terabytes of addresses
  const rlimit addresses{rlim_t{8} << 30U, rlim_t{8} << 30U};
  ::setrlimit(RLIMIT_AS, &addresses);
#endif
}

/// returns the exit status: 0 once the run is at its end.
int answer_run() {
  OIIO::attribute("threads", 2);
  Packet request;
  while (receive(request)) {
    if (request.header.status == static_cast<std::uint32_t>(HelperTask::kEndOfRun)) return 0;
    ::alarm(kSecondsEach);  // ends this process should the other one not be there to do it
    Packet answer = answer_to(request);
    ::alarm(0);
    if (!send(answer)) return 1;
  }
  return 1;
}

/// Whether there is another run: not if the input is at its end, or nothing comes for a while.
bool wait_for_run() {
  for (;;) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const int ready = ::poll(&input, 1, kIdleSeconds * 1000);
    if (ready < 0 && errno == EINTR) continue;
    char first = 0;
    return ready > 0 && ::recv(STDIN_FILENO, &first, 1, MSG_PEEK) == 1;
  }
}

/// Ends as the process of a run did.
int end_as(int status) {
  if (!WIFSIGNALED(status)) return WEXITSTATUS(status);
  std::signal(WTERMSIG(status), SIG_DFL);
  ::kill(::getpid(), WTERMSIG(status));
  return 1;
}

/// In the process of a run.
[[noreturn]] void run_for(pid_t server) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != server) std::_Exit(1);  // it was gone before
  std::_Exit(answer_run());  // the libraries behind OpenImageIO take their time, and crash, while going down
}

/// Loading the libraries takes longer than most images: they are loaded once, and each run begins from there.
int serve() {
  limit_resources();
  const pid_t server = ::getpid();
  while (wait_for_run()) {
    const pid_t run = ::fork();
    if (run < 0) return 1;
    if (run == 0) run_for(server);
    int status = 0;
    pid_t ended = -1;
    while ((ended = ::waitpid(run, &status, 0)) < 0 && errno == EINTR) {
    }
    ::kill(-run, SIGKILL);  // what it left behind
    if (ended != run) return 1;
    if (status != 0) return end_as(status);
  }
  return 0;
}

}  // namespace
}  // namespace luminist

int main(int argc, char** argv) {
  if (argc != 2 || std::string_view(argv[1]) != luminist::kServeWord) {
    std::fputs("luminist-image is a part of luminist that is not called by hand\n", stderr);
    return 2;
  }
  std::_Exit(luminist::serve());
}
