#include "gpu/program.h"

#include <gtest/gtest.h>

#include <numeric>
#include <optional>
#include <vector>

#include "gpu/gl_buffer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class Programs : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = Device::create_headless();
    ASSERT_TRUE(made) << made.error().message();
    device_.emplace(std::move(made).value());
  }
  Error compile_error(const std::vector<SourceChunk>& chunks) {
    return error_of(Program::compute(*device_, chunks, "test"));
  }
  std::optional<Device> device_;
};

const char* const kIndex = R"(
layout(local_size_x = 64) in;
uint linear_index() {
  return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
}
)";

TEST_F(Programs, ComputeRunsOverEveryIndexAcrossChunks) {
  const std::vector<SourceChunk> chunks{{"index.glsl", kIndex}, {"main.comp", R"(
layout(std430, binding = 0) buffer Values { uint values[]; };
uniform uint count;
void main() {
  uint i = linear_index();
  if (i < count) values[i] += i;
}
)"}};
  LUM_ASSERT_OK(Program program, Program::compute(*device_, chunks, "iota"));
  const unsigned count = 1000;
  LUM_ASSERT_OK(const GlBuffer buffer, GlBuffer::create(*device_, BufferUse::kStorage, count * 4, "values"));
  buffer.bind_storage(0);
  program.set("count", count);
  program.dispatch(*device_, count);
  std::vector<unsigned> back(count);
  buffer.read(0, std::span(back));
  std::vector<unsigned> expected(count);
  std::iota(expected.begin(), expected.end(), 0U);
  EXPECT_EQ(back, expected);
}

TEST_F(Programs, DispatchCoversMoreThanOneRowOfGroups) {
  const std::vector<SourceChunk> chunks{{"main.comp", R"(
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Values { uint values[]; };
void main() {
  uint i = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (i < values.length()) values[i] += 1u;
}
)"}};
  LUM_ASSERT_OK(const Program program, Program::compute(*device_, chunks, "rows"));
  const std::size_t count = 70000;  // above the 65,535 groups that fit into a row on the smallest devices
  LUM_ASSERT_OK(const GlBuffer buffer, GlBuffer::create(*device_, BufferUse::kStorage, count * 4, "values"));
  buffer.bind_storage(0);
  program.dispatch(*device_, count, 1);
  std::vector<unsigned> back(count);
  buffer.read(0, std::span(back));
  EXPECT_EQ(back, std::vector<unsigned>(count, 1U));
}

TEST_F(Programs, MistakeIsReportedAtTheFileAndLineOfItsChunk) {
  const Error error =
      compile_error({{"first.glsl", "float one() { return 1.0; }\n"},
                     {"styles/mine/shade.glsl", "float two() {\n  return 2.0;\n}\nfloat bad() { return nix; }\n"},
                     {"last.comp", "layout(local_size_x = 1) in;\nvoid main() {}\n"}});
  EXPECT_EQ(error.kind, ErrorKind::kStyle);
  EXPECT_EQ(error.where.substr(0, std::string("styles/mine/shade.glsl:4").size()), "styles/mine/shade.glsl:4");
  EXPECT_NE(error.what.find("nix"), std::string::npos);
}

TEST_F(Programs, MistakeInTheFirstLineOfALaterChunkBelongsToThatChunk) {
  const Error error = compile_error({{"a.glsl", "float a() { return 1.0; }"}, {"b.glsl", "float b() { return nix; }"}});
  EXPECT_EQ(error.where.substr(0, 8), "b.glsl:1");
}

TEST_F(Programs, ChunkOfManyLinesDoesNotRunIntoTheNext) {
  const Error error =
      compile_error({{"long.glsl", std::string(25000, '\n')}, {"b.glsl", "\nfloat b() { return nix; }"}});
  EXPECT_EQ(error.where.substr(0, 8), "b.glsl:2");
}

TEST_F(Programs, MissingFunctionIsRefusedWhenLinking) {
  const Error error = compile_error(
      {{"a.comp", "layout(local_size_x = 1) in;\nfloat f();\nshared float s;\nvoid main() { s = f(); }\n"}});
  EXPECT_EQ(error.kind, ErrorKind::kStyle);
  EXPECT_FALSE(error.what.empty());
}

TEST(ShaderError, ReadsTheFormOfMesa) {
  const std::vector<SourceChunk> chunks{{"a.glsl", "\n\n"}, {"b.glsl", "\n\n\n\n"}};
  const Error error = shader_error(chunks, "0:20003(7): warning: odd\n0:20004(12): error: `nix' undeclared\n", "label");
  EXPECT_EQ(error.where, "b.glsl:4:12");
  EXPECT_EQ(error.what, "`nix' undeclared");
}

TEST(ShaderError, ReadsTheFormOfNvidia) {
  const std::vector<SourceChunk> chunks{{"a.glsl", "\n\n"}, {"b.glsl", "\n\n\n\n"}};
  const Error error = shader_error(chunks, "0(10002) : error C1503: undefined variable \"nix\"\n", "label");
  EXPECT_EQ(error.where, "a.glsl:2");
  EXPECT_NE(error.what.find("undefined variable"), std::string::npos);
}

TEST(ShaderError, KeepsALogItCannotRead) {
  const Error error = shader_error({}, "something else\nmore", "the label");
  EXPECT_EQ(error.where, "the label");
  EXPECT_NE(error.what.find("something else"), std::string::npos);
}

}  // namespace
}  // namespace luminist
