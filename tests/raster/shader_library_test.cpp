#include "raster/shader_library.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "support/fixtures.h"

namespace luminist {
namespace {

class ShaderLibraryTest : public testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(device_, Device::create_headless());
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
  }

  /// Compiles the cinematic style's manifest with another shade file.
  Result<Program> compile_text(const std::string& glsl) {
    const std::string path = folder_.file("mine.glsl");
    std::ofstream(path) << glsl;
    Style style = load_style(AssetRoots::standard(), "cinematic").value();
    style.glsl_path = path;
    return compile(style);
  }
  Result<Program> compile(const Style& style) {
    const RelightLayout layout = relight_layout(device_->info().max_uniform_block_bytes, *types_, style);
    return compile_relight(*device_, layout, *types_, style, AssetRoots::standard());
  }

  TemporaryFolder folder_;
  std::optional<Device> device_;
  std::optional<LightTypes> types_;
};

TEST_F(ShaderLibraryTest, EveryStyleCompiles) {
  for (const std::string& name : style_names(AssetRoots::standard())) {
    LUM_ASSERT_OK(Style style, load_style(AssetRoots::standard(), name));
    if (style.engine != StyleEngine::kRaster) continue;
    if (!style.shades()) {
      LUM_ASSERT_OK(style, load_style(AssetRoots::standard(), "cinematic+" + name));
    }
    LUM_EXPECT_OK(compile(style));
  }
}

TEST_F(ShaderLibraryTest, AStyleMayUseEverythingTheHostPromises) {
  LUM_EXPECT_OK(compile_text(R"(vec3 shade(Surface s) {
    vec3 c = ambient() + s.position + s.normal + s.view + s.albedo + s.specular + s.emissive;
    c += s.roughness + float(s.object + s.material) + style.specular + luminance(c) + saturate(c.x);
    for (int i = 0; i < light_count(); ++i) {
      LightSample l = light(i, s);
      c += l.direction + l.color + l.shape + l.lit + l.visibility + soft_threshold(0.5, 0.1, l.lit);
    }
    return safe_normalize(c, vec3(1.0));
  })"));
}

TEST_F(ShaderLibraryTest, AMistakeIsReportedAtTheAuthorsLine) {
  const Error error = error_of(compile_text("// one\n// two\nvec3 shade(Surface s) {\n  return s.colour;\n}\n"));
  EXPECT_EQ(error.kind, ErrorKind::kStyle);
  EXPECT_TRUE(error.where.starts_with(folder_.file("mine.glsl") + ":4")) << error.message();
  EXPECT_NE(error.what.find("colour"), std::string::npos) << error.message();
}

TEST_F(ShaderLibraryTest, AFileWithoutShadeOrWithAnOpenBraceIsReportedAtThatFile) {
  for (const char* text : {"float helper() { return 1.0; }\n", "vec3 shade(Surface s) {\n  return s.albedo;\n"}) {
    const Error error = error_of(compile_text(text));
    EXPECT_EQ(error.kind, ErrorKind::kStyle);
    EXPECT_TRUE(error.where.starts_with(folder_.file("mine.glsl"))) << error.message();
    EXPECT_NE(error.hint.find("vec3 shade(Surface s)"), std::string::npos) << error.message();
  }
}

TEST_F(ShaderLibraryTest, AStylesFileThatIsMissingIsMissing) {
  Style style = load_style(AssetRoots::standard(), "cinematic").value();
  style.glsl_path = folder_.file("nowhere.glsl");
  EXPECT_EQ(error_of(compile(style)).kind, ErrorKind::kMissing);
}

TEST(RelightLayout, FillsUniformBlocksAndAlwaysHoldsOneBlock) {
  LUM_ASSERT_OK(const LightTypes types, LightTypes::load(AssetRoots::standard()));
  LUM_ASSERT_OK(const Style style, load_style(AssetRoots::standard(), "toon"));
  const RelightLayout layout = relight_layout(16384, types, style);
  ASSERT_EQ(layout.light_types.size(), types.all().size());
  for (const BlockArray& array : layout.light_types) {
    EXPECT_LE(array.bytes(), 16384U);
    EXPECT_GT(array.bytes() + array.stride, 16384U);
  }
  EXPECT_EQ(relight_layout(1, types, style).style.capacity, 1U);
}

}  // namespace
}  // namespace luminist
