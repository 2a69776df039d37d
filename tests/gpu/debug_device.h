#pragma once
// tests/gpu/debug_device.h -- a debug device for a test; the driver must not have complained when the test ends.
#include <gtest/gtest.h>

#include <optional>
#include <utility>

#include "gpu/device.h"
#include "support/fixtures.h"

namespace luminist {

class DebugDeviceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = Device::create_headless({.debug = true});
    ASSERT_TRUE(made) << made.error().message();
    device_.emplace(std::move(made).value());
  }
  void TearDown() override {
    for (const DeviceMessage& message : device_->take_messages()) EXPECT_FALSE(message.error) << message.text;
  }
  std::optional<Device> device_;
};

}  // namespace luminist
