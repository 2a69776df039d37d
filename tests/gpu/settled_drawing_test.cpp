#include "gpu/settled_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "gpu/gl_buffer.h"
#include "gpu/gl_framebuffer.h"
#include "gpu/gl_vertex_array.h"
#include "gpu/program.h"
#include "support/fixtures.h"
#include "support/held_memory.h"

namespace luminist {
namespace {

struct Target {
  GlTexture texture;  ///< 16 MB where the size is 1024
  GlFramebuffer framebuffer;
};

Target drawn_on(Device& device, int size) {
  auto texture = GlTexture::create_2d(device, GL_RGBA32F, size, size, "large");
  EXPECT_TRUE(texture);
  if (!texture) return {};
  Target target{std::move(*texture), GlFramebuffer::create(device, "large")};
  target.framebuffer.attach_color(0, target.texture);
  LUM_EXPECT_OK(target.framebuffer.finish(1));
  target.framebuffer.bind(size, size);
  const std::array<float, 4> red{1.0F, 0.0F, 0.0F, 1.0F};
  glClearNamedFramebufferfv(target.framebuffer.name(), GL_COLOR, 0, red.data());
  return target;
}

class SettledDrawingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(device_, Device::create_headless());
    if (!device_->info().software) GTEST_SKIP() << "the driver's memory is its own";
  }
  /// Bytes the driver keeps of what `act` made large and deleted again, beyond what it keeps of a small one.
  std::size_t kept_of(const std::function<void(int)>& act) {
    act(16);
    const std::size_t before = held_bytes();
    for (int i = 0; i < 4; ++i) act(kLarge);
    LUM_EXPECT_OK(device_->check_errors("settled drawing"));
    return std::max(held_bytes(), before) - before;
  }
  static constexpr int kLarge = 1024;
  static constexpr std::size_t kFew = 4'000'000;
  std::optional<Device> device_;
};

TEST_F(SettledDrawingTest, LeavesNothingOfWhatWasDeleted) {
  const auto act = [this](int size) {
    for (int i = 0; i < 2; ++i) {
      const SettledDrawing drawing(*device_);
      drawn_on(*device_, size);
    }
  };
  EXPECT_LT(kept_of(act), kFew) << "a quarter of one of the textures";
}

TEST_F(SettledDrawingTest, LeavesNothingThoughTrianglesFillSlots) {
  constexpr int kTriangles = 150'000;
  const SourceChunk vertex{"triangles.vert", R"(
flat out vec4 a; out vec4 b; out vec4 c; out vec4 d; out vec4 e; out vec4 f;
void main() {
  vec2 corner = vec2(gl_VertexID % 3 == 1, gl_VertexID % 3 == 2);
  a = b = c = d = e = f = vec4(corner, 0.0, 1.0);
  gl_Position = vec4(0.01 * corner, 0.0, 1.0);
})"};
  const SourceChunk fragment{"triangles.frag", R"(
flat in vec4 a; in vec4 b; in vec4 c; in vec4 d; in vec4 e; in vec4 f;
out vec4 color;
void main() { color = a + b + c + d + e + f; })"};
  LUM_ASSERT_OK(const Program program, Program::graphics(*device_, {&vertex, 1}, {&fragment, 1}, "triangles"));
  std::vector<GLuint> corners(std::size_t{3} * kTriangles);
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<GLuint>(i % 3);
  LUM_ASSERT_OK(const GlBuffer indices,
                GlBuffer::create(*device_, BufferUse::kVertex, std::span<const GLuint>(corners), "corners"));
  GlVertexArray array = GlVertexArray::create(*device_, "corners");
  array.set_indices(indices);
  const auto act = [&](int size) {
    SettledDrawing drawing(*device_);
    const Target target = drawn_on(*device_, size);
    array.bind();
    program.use();
    drawing.triangles(3 * (size < kLarge ? 1 : kTriangles), 0, 0);
  };
  EXPECT_LT(kept_of(act), kFew);
}

TEST_F(SettledDrawingTest, LeavesNothingThoughOtherDrawingIsUnderWay) {
  const auto act = [this](int size) {
    const Target under_way = drawn_on(*device_, 4 * size);
    glFlush();
    const SettledDrawing drawing(*device_);
    drawn_on(*device_, size);
  };
  const auto end = [&](int size) {
    act(size);
    const SettledDrawing drawing(*device_);  // takes the place of the one that was under way
  };
  EXPECT_LT(kept_of(end), kFew);
}

TEST_F(SettledDrawingTest, LeavesNothingOfPicturesAndTheirLevels) {
  const auto act = [this](int size) {
    const Image image(size, size, 3);
    LUM_ASSERT_OK(const GlTexture texture, GlTexture::create_picture(*device_, image, true, true, "picture"));
  };
  EXPECT_LT(kept_of(act), kFew) << "half of a picture";
}

}  // namespace
}  // namespace luminist
