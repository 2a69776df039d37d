#include "gpu/device.h"

#include <gtest/gtest.h>

#include "gpu/gl_buffer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

TEST(Device, IsCreatedHeadlessAndTellsItsLimits) {
  LUM_ASSERT_OK(Device device, Device::create_headless());
  const DeviceInfo& info = device.info();
  EXPECT_FALSE(info.vendor.empty());
  EXPECT_FALSE(info.renderer.empty());
  EXPECT_EQ(info.platform.substr(0, 3), "EGL");
  // The least values that OpenGL 4.5 promises.
  EXPECT_GE(info.max_texture_size, 16384);
  EXPECT_GE(info.max_array_layers, 2048);
  EXPECT_GE(info.max_storage_block_bytes, 1 << 24);
  EXPECT_GE(info.max_groups_x, 65535);
}

TEST(Device, CanBeMadeAgainAfterItIsGone) {
  for (int i = 0; i < 3; ++i) {
    LUM_ASSERT_OK(Device device, Device::create_headless());
    LUM_EXPECT_OK(GlBuffer::create(device, BufferUse::kStorage, 64, "probe"));
  }
}

TEST(Device, CannotBeAdoptedWithoutAContext) {
  const Error error = error_of(Device::adopt());
  EXPECT_EQ(error.kind, ErrorKind::kGl);
}

TEST(Device, AdoptsTheContextThatIsCurrent) {
  LUM_ASSERT_OK(const Device owner, Device::create_headless());
  LUM_ASSERT_OK(const Device adopted, Device::adopt());
  EXPECT_EQ(adopted.info().renderer, owner.info().renderer);
  EXPECT_EQ(adopted.info().platform, "adopted");
}

TEST(Device, TellsTheOwnerOfAnAdoptedContextWhenItGoes) {
  LUM_ASSERT_OK(const Device owner, Device::create_headless());
  int released = 0;
  {
    LUM_ASSERT_OK(const Device adopted, Device::adopt([&] { ++released; }));
    EXPECT_EQ(released, 0);
  }
  EXPECT_EQ(released, 1);
}

TEST(Device, TurnsAnOpenGlErrorIntoOneErrorAndIsCleanAfterwards) {
  LUM_ASSERT_OK(Device device, Device::create_headless({.debug = true}));
  LUM_EXPECT_OK(device.check_errors("begin"));
  glEnable(GL_RGBA);  // no capability: GL_INVALID_ENUM
  const Error error = error_of(device.check_errors("enable nonsense"));
  EXPECT_EQ(error.kind, ErrorKind::kGl);
  EXPECT_NE(error.what.find("enable nonsense"), std::string::npos);
  LUM_EXPECT_OK(device.check_errors("go on"));
}

TEST(Device, CollectsWhatTheDriverSays) {
  LUM_ASSERT_OK(Device device, Device::create_headless({.debug = true}));
  device.take_messages();
  glEnable(GL_RGBA);
  const auto messages = device.take_messages();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_TRUE(messages[0].error);
  EXPECT_TRUE(device.take_messages().empty());
}

TEST(Device, GivesEveryIdentityOnce) {
  LUM_ASSERT_OK(Device device, Device::create_headless());
  EXPECT_EQ(device.new_id(), 1U);
  EXPECT_EQ(device.new_id(), 2U);
}

}  // namespace
}  // namespace luminist
