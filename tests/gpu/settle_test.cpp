#include "gpu/settle.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <array>

#include "gpu/gl_framebuffer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

std::size_t held_bytes() {
  const struct mallinfo2 info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Draws on two framebuffers of 16 MB each, then deletes both.
void draw_and_delete(Device& device) {
  for (int i = 0; i < 2; ++i) {
    LUM_ASSERT_OK(GlTexture texture, GlTexture::create_2d(device, GL_RGBA32F, 1024, 1024, "large"));
    GlFramebuffer framebuffer = GlFramebuffer::create(device, "large");
    framebuffer.attach_color(0, texture);
    LUM_EXPECT_OK(framebuffer.finish(1));
    const std::array<float, 4> red{1.0F, 0.0F, 0.0F, 1.0F};
    glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, red.data());
    settle(device);
  }
}

TEST(Settle, LeavesNothingOfWhatWasDeleted) {
  LUM_ASSERT_OK(Device device, Device::create_headless());
  if (!device.info().software) GTEST_SKIP() << "the driver's memory is its own";
  draw_and_delete(device);  // what the driver keeps for good
  const std::size_t before = held_bytes();
  for (int i = 0; i < 4; ++i) draw_and_delete(device);
  EXPECT_LT(held_bytes(), before + 4'000'000U) << "a quarter of one of the textures";
  LUM_EXPECT_OK(device.check_errors("settle"));
}

}  // namespace
}  // namespace luminist
