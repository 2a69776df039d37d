#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "gpu/debug_device.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_framebuffer.h"
#include "gpu/gl_texture.h"

namespace luminist {
namespace {

using GlObjects = DebugDeviceTest;

TEST_F(GlObjects, BufferGivesBackWhatWasWritten) {
  const std::vector<float> values{1, 2, 3, 4, 5};
  LUM_ASSERT_OK(GlBuffer buffer, GlBuffer::create(*device_, BufferUse::kStorage, std::span(values), "values"));
  buffer.write(sizeof(float), std::span(values).first(2));
  std::vector<float> back(5);
  buffer.read(0, std::span(back));
  EXPECT_EQ(back, (std::vector<float>{1, 1, 2, 4, 5}));
}

TEST_F(GlObjects, BufferStartsAtZeroAndIsFilledByRange) {
  LUM_ASSERT_OK(GlBuffer buffer, GlBuffer::create(*device_, BufferUse::kStorage, 20, "zeros"));
  buffer.fill(4, 8, 0.5F);
  std::vector<float> back(5);
  buffer.read(0, std::span(back));
  EXPECT_EQ(back, (std::vector<float>{0, 0.5F, 0.5F, 0, 0}));
}

TEST_F(GlObjects, LargeWriteAfterAFillIsWhatIsRead) {
  const std::vector<float> values(1U << 18U, 7.0F);
  LUM_ASSERT_OK(GlBuffer buffer, GlBuffer::create(*device_, BufferUse::kStorage, values.size() * 4, "large"));
  std::vector<float> back(values.size());
  buffer.write(0, std::span(values));
  buffer.read(0, std::span(back));
  EXPECT_EQ(back, values);
  buffer.fill(0, values.size() * 4, 1.0F);
  buffer.write(0, std::span(values));
  buffer.read(0, std::span(back));
  EXPECT_TRUE(back == values);
}

TEST_F(GlObjects, BufferOfNothingIsValid) {
  LUM_ASSERT_OK(const GlBuffer buffer, GlBuffer::create(*device_, BufferUse::kStorage, 0, "nothing"));
  buffer.bind_storage(0);
  EXPECT_EQ(buffer.bytes(), 0U);
}

TEST_F(GlObjects, BufferAboveTheBlockSizeIsALimitThatNamesIt) {
  const auto too_many = static_cast<std::size_t>(device_->info().max_storage_block_bytes) + 4;
  const Error error = error_of(GlBuffer::create(*device_, BufferUse::kStorage, too_many, "the samples"));
  EXPECT_EQ(error.kind, ErrorKind::kLimit);
  EXPECT_NE(error.what.find("the samples"), std::string::npos);
}

TEST_F(GlObjects, MovedBufferLeavesNothingBehind) {
  LUM_ASSERT_OK(GlBuffer first, GlBuffer::create(*device_, BufferUse::kVertex, 64, "moved"));
  const GLuint name = first.name();
  const GlBuffer second = std::move(first);
  EXPECT_EQ(second.name(), name);
  EXPECT_TRUE(glIsBuffer(name));
}

TEST_F(GlObjects, DestroyedBufferIsGone) {
  GLuint name = 0;
  {
    LUM_ASSERT_OK(const GlBuffer buffer, GlBuffer::create(*device_, BufferUse::kVertex, 64, "short-lived"));
    name = buffer.name();
    EXPECT_TRUE(glIsBuffer(name));
  }
  EXPECT_FALSE(glIsBuffer(name));
}

TEST_F(GlObjects, TextureAboveTheSizeIsALimit) {
  const int side = device_->info().max_texture_size + 1;
  EXPECT_EQ(error_of(GlTexture::create_2d(*device_, GL_R8, side, 1, "wide")).kind, ErrorKind::kLimit);
}

TEST_F(GlObjects, PictureKeepsItsFirstRowFirstAndSpreadsGrey) {
  Image image(1, 2, 1);
  image.at(0, 0, 0) = 0.25F;
  image.at(0, 1, 0) = 0.75F;
  LUM_ASSERT_OK(const GlTexture texture, GlTexture::create_picture(*device_, image, true, true, "grey"));
  std::array<float, 8> texels{};
  glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT, sizeof(texels), texels.data());
  // Powers of two are exact in half floats.
  EXPECT_EQ(texels, (std::array<float, 8>{0.25F, 0.25F, 0.25F, 1.0F, 0.75F, 0.75F, 0.75F, 1.0F}));
}

TEST_F(GlObjects, PictureHasAllMipmapsAndTheLastIsTheMean) {
  Image image(8, 4, 3);
  for (std::size_t i = 0; i < image.pixels(); ++i) image.set_rgb(i, Vec3(i % 2 == 0 ? 1.0F : 0.0F));
  LUM_ASSERT_OK(const GlTexture texture, GlTexture::create_picture(*device_, image, true, true, "stripes"));
  std::array<float, 4> texel{};
  glGetTextureImage(texture.name(), 3, GL_RGBA, GL_FLOAT, sizeof(texel), texel.data());
  EXPECT_NEAR(texel[0], 0.5F, 1e-3F);  // half floats
}

TEST_F(GlObjects, FramebufferClearsItsLayerAlone) {
  LUM_ASSERT_OK(const GlTexture texture, GlTexture::create_2d_array(*device_, GL_RGBA32F, 2, 2, 2, "layers"));
  for (int layer = 0; layer < 2; ++layer) {
    GlFramebuffer framebuffer = GlFramebuffer::create(*device_, "target");
    framebuffer.attach_color(0, texture, layer);
    LUM_EXPECT_OK(framebuffer.finish(1));
    const std::array<float, 4> color{static_cast<float>(layer + 1), 0, 0, 0};
    glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, color.data());
  }
  std::array<float, 32> texels{};
  glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT, sizeof(texels), texels.data());
  EXPECT_EQ(texels[0], 1.0F);
  EXPECT_EQ(texels[16], 2.0F);
}

TEST_F(GlObjects, FramebufferWithoutAttachmentsIsRefused) {
  GlFramebuffer framebuffer = GlFramebuffer::create(*device_, "empty");
  EXPECT_EQ(error_of(framebuffer.finish(0)).kind, ErrorKind::kGl);
}

}  // namespace
}  // namespace luminist
