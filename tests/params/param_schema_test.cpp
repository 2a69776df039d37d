#include "params/param_schema.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "base/files.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

std::shared_ptr<const ParamSchema> parsed_schema(std::string_view manifest) {
  auto schema = ParamSchema::parse(manifest, "test.toml");
  EXPECT_TRUE(schema.has_value()) << (schema ? "" : schema.error().message());
  return schema ? *schema : nullptr;
}

/// A parameter as it would be written; an empty range is left out.
std::string table(const std::string& name, const std::string& type, const std::string& value, const std::string& range,
                  const std::string& more = "") {
  return fmt::format("[[param]]\nname = \"{}\"\ntype = \"{}\"\ndefault = {}\n{}doc = \"d\"\n{}", name, type, value,
                     range.empty() ? "" : "range = " + range + "\n", more);
}

TEST(ParamSchema, ReadsEveryKeyOfAParameter) {
  const auto schema = parsed_schema(
      "doc = \"the caller's\"\n[[param]]\nname = \"barn\"\ntype = \"vec3\"\ndefault = [0.3, 0.4, 0.1]\n"
      "range = [[0.1, 0.2, 0.01], [1, 2, 0.5]]\nscale = \"log\"\nunit = \"tan angle\"\ngroup = \"Shape\"\n"
      "role = \"shape\"\nsolve = true\nquality = false\ndoc = \"Half width.\"\n");
  ASSERT_EQ(schema->size(), 1);
  const ParamSpec& spec = (*schema)[0];
  EXPECT_EQ(spec.name, "barn");
  EXPECT_EQ(spec.type, ParamType::kVec3);
  EXPECT_EQ(spec.default_value, (std::vector{0.3, 0.4, 0.1}));
  EXPECT_EQ(spec.range_min, (std::vector{0.1, 0.2, 0.01}));
  EXPECT_EQ(spec.range_max, (std::vector{1.0, 2.0, 0.5}));
  EXPECT_EQ(spec.scale, ParamScale::kLog);
  EXPECT_EQ(spec.unit, "tan angle");
  EXPECT_EQ(spec.group, "Shape");
  EXPECT_EQ(spec.role, "shape");
  EXPECT_EQ(spec.doc, "Half width.");
  EXPECT_TRUE(spec.solve);
  EXPECT_EQ(spec.dofs(), 3);
}

TEST(ParamSchema, BroadcastsOneRangeToEveryComponent) {
  const auto schema = parsed_schema(table("tint", "color", "[1, 1, 1]", "[0, 4]"));
  EXPECT_EQ((*schema)[0].range_min, (std::vector{0.0, 0.0, 0.0}));
  EXPECT_EQ((*schema)[0].range_max, (std::vector{4.0, 4.0, 4.0}));
}

TEST(ParamSchema, NormalizesTheDefaultOfADirection) {
  const auto schema = parsed_schema(table("aim", "direction", "[0, -3, 4]", "[-1, 1]"));
  EXPECT_EQ((*schema)[0].default_value, (std::vector{0.0, -0.6, 0.8}));
}

TEST(ParamSchema, PlacesMembersAsStd140Does) {
  const auto schema = parsed_schema(table("a", "float", "0", "[0, 1]") + table("b", "vec2", "[0, 0]", "[0, 1]") +
                                    table("c", "float", "0", "[0, 1]") + table("d", "vec3", "[0, 0, 0]", "[0, 1]") +
                                    table("e", "float", "0", "[0, 1]") + table("f", "color", "[0, 0, 0]", "[0, 1]") +
                                    table("g", "direction", "[0, 0, 1]", "[-1, 1]") + table("h", "bool", "true", "") +
                                    table("i", "int", "3", "[0, 9]") +
                                    table("j", "choice", "\"soft\"", "", "choices = [\"hard\", \"soft\"]\n"));
  const std::size_t by_hand[] = {0, 8, 16, 32, 44, 48, 64, 76, 80, 84};
  ASSERT_EQ(schema->size(), 10);
  for (int i = 0; i < 10; ++i) EXPECT_EQ((*schema)[i].offset, by_hand[i]) << (*schema)[i].name;
  EXPECT_EQ(schema->byte_size(), 96U);
  EXPECT_EQ(schema->glsl_struct("Mix"),
            "struct Mix {\n  float a;\n  vec2 b;\n  float c;\n  vec3 d;\n  float e;\n  vec3 f;\n  vec3 g;\n  uint h;\n"
            "  int i;\n  int j;\n};\n");
}

TEST(ParamSchema, CountsDegreesOfFreedomInOrder) {
  const auto schema = parsed_schema(
      table("on", "bool", "true", "") + table("aim", "direction", "[0, 0, 1]", "[-1, 1]") +
      table("blur", "float", "0.1", "[0, 1]", "quality = true\n") + table("tint", "color", "[1, 1, 1]", "[0, 4]"));
  EXPECT_EQ((*schema)[1].first_dof, 0);
  EXPECT_EQ((*schema)[2].dofs(), 0);  // a quality
  EXPECT_EQ((*schema)[3].first_dof, 2);
  EXPECT_EQ(schema->dofs(), 5);
}

TEST(ParamSchema, OfNothingIsAStructThatGlslAccepts) {
  const auto schema = parsed_schema("doc = \"none\"\n");
  EXPECT_EQ(schema->size(), 0);
  EXPECT_EQ(schema->byte_size(), 16U);
  EXPECT_EQ(schema->glsl_struct("Empty"), "struct Empty {\n  float unused;\n};\n");
}

TEST(ParamSchema, FindsByNameAndByRole) {
  const auto schema = parsed_schema(table("near", "float", "0", "[0, 1]", "role = \"cutoff\"\n") +
                                    table("far", "float", "1", "[0, 1]", "role = \"cutoff\"\n"));
  EXPECT_EQ(schema->find("far"), 1);
  EXPECT_EQ(schema->find("middle"), std::nullopt);
  EXPECT_EQ(schema->by_role("cutoff"), 0);
  EXPECT_EQ(schema->by_role("color"), std::nullopt);
  EXPECT_EQ(schema->names(), (std::vector<std::string>{"near", "far"}));
}

/// One mistake in a manifest: what is written, where it must be reported and which words must be there.
struct Mistake {
  std::string manifest;
  std::string where;
  std::string says;
};

TEST(ParamSchema, ReportsEachMistakeAtItsPlace) {
  const std::string good = table("one", "float", "0.5", "[0, 1]");  // 6 lines
  const Mistake mistakes[] = {
      {good + "[[param]]\nnam = \"two\"\n", "test.toml:8:1", "did you mean \"name\""},
      {table("a", "float", "0.5", "[0, 1]", "rnge = [0, 1]\n"), "test.toml:7:1", "did you mean \"range\""},
      {table("a", "flaot", "0.5", "[0, 1]"), "test.toml:3:8", "did you mean \"float\""},
      {table("a", "float", "\"x\"", "[0, 1]"), "test.toml:4:11", "a number is wanted here, not a string"},
      {table("a", "vec3", "[0, 0]", "[0, 1]"), "test.toml:4:11", "has 3 numbers, not 2"},
      {table("a", "vec2", "[0, true]", "[0, 1]"), "test.toml:4:15", "a number is wanted here, not true or false"},
      {table("a", "float", "nan", "[0, 1]"), "test.toml:4:11", "not finite"},
      {table("a", "float", "1e39", "[0, 1]"), "test.toml:4:11", "not finite"},
      {table("a", "float", "2", "[0, 1]"), "test.toml:4:11", "outside the range [0, 1]"},
      {table("a", "float", "0.5", "[1, 0]"), "test.toml:5:9", "does not rise"},
      {table("a", "float", "0.5", "[0.5, 0.5]"), "test.toml:5:9", "does not rise"},
      {table("a", "float", "0.5", "[0, inf]"), "test.toml:5:9", "not finite"},
      {table("a", "float", "0.5", "[0, 1, 2]"), "test.toml:5:9", "[min, max]"},
      {table("a", "float", "0.5", ""), "test.toml:1:1", "\"range\" is missing"},
      {table("a", "bool", "true", "[0, 1]"), "test.toml:5:9", "a bool has no range"},
      {table("a", "int", "0.5", "[0, 1]"), "test.toml:4:11", "whole number"},
      {table("a", "int", "1", "[0, 1]", "solve = true\n"), "test.toml:7:9", "no degree of freedom"},
      {table("a", "float", "1", "[0, 1]", "solve = true\nquality = true\n"), "test.toml:7:9", "a quality has no"},
      {table("a", "float", "1", "[0, 1]", "solve = 1\n"), "test.toml:7:9", "true or false is wanted"},
      {table("a", "float", "1", "[0, 1]", "scale = \"lg\"\n"), "test.toml:7:9", "did you mean \"log\""},
      {table("a", "float", "1", "[0, 1]", "scale = \"log\"\n"), "test.toml:5:9", "cannot start at 0"},
      {table("a", "color", "[1, 1, 1]", "[0, 1]", "scale = \"scene\"\n"), "test.toml:7:9", "no length"},
      {table("a", "direction", "[0, 0, 0]", "[-1, 1]"), "test.toml:4:11", "cannot be zero"},
      {table("a", "choice", "\"x\"", ""), "test.toml:1:1", "two names or more"},
      {table("a", "choice", "\"sotf\"", "", "choices = [\"soft\", \"hard\"]\n"), "test.toml:4:11",
       "did you mean \"soft\""},
      {table("a", "choice", "\"x\"", "", "choices = [\"x\"]\n"), "test.toml:6:11", "two names or more"},
      {table("a", "choice", "\"x\"", "", "choices = [\"x\", 1]\n"), "test.toml:6:17", "a string is wanted here"},
      {table("A", "float", "1", "[0, 1]"), "test.toml:2:8", "is no parameter name"},
      {table("gl_a", "float", "1", "[0, 1]"), "test.toml:2:8", "is no parameter name"},
      {table("a__b", "float", "1", "[0, 1]"), "test.toml:2:8", "is no parameter name"},
      {table("filter", "float", "1", "[0, 1]"), "test.toml:2:8", "reserved word of GLSL"},
      {table("mat3x4", "float", "1", "[0, 1]"), "test.toml:2:8", "reserved word of GLSL"},
      {good + good, "test.toml:8:8", "used twice"},
      {"[[param]]\nname = \"a\"\ntype = \"float\"\ndefault = 1\nrange = [0, 1]\n", "test.toml:1:1",
       "\"doc\" is missing"},
      {"param = 3\n", "test.toml:1:9", "an array is wanted here"},
      {"param = [3]\n", "test.toml:1:10", "write [[param]]"},
      {"[[param]]\nname = \n", "test.toml:2:8", ""},
      {"[[param]]\nname = \"a\"\nname = \"b\"\n", "test.toml:3:8", "redefine"},
  };
  for (const Mistake& mistake : mistakes) {
    const Error error = error_of(ParamSchema::parse(mistake.manifest, "test.toml"));
    EXPECT_EQ(error.kind, ErrorKind::kStyle) << mistake.manifest;
    EXPECT_EQ(error.where, mistake.where) << mistake.manifest << error.message();
    EXPECT_NE(error.message().find(mistake.says), std::string::npos) << mistake.manifest << error.message();
  }
}

TEST(ParamSchema, RefusesMoreThanAThousandParameters) {
  std::string manifest;
  for (int i = 0; i < 1000; ++i) manifest += table(fmt::format("p{}", i), "float", "0", "[0, 1]");
  EXPECT_EQ(parsed_schema(manifest)->size(), 1000);
  const Error error = error_of(ParamSchema::parse(manifest + table("last", "float", "0", "[0, 1]"), "test.toml"));
  EXPECT_EQ(error.where, "test.toml:6002:8");
  EXPECT_NE(error.what.find("more than 1000"), std::string::npos);
}

TEST(ParamSchema, RefusesAnyPrefixOfAManifestWithoutHarm) {
  const std::string manifest = table("a", "vec3", "[0, 0, 0]", "[0, 1]") + table("b", "bool", "true", "");
  for (std::size_t length = 0; length < manifest.size(); ++length) {
    const auto schema = ParamSchema::parse(std::string_view(manifest).substr(0, length), "test.toml");
    if (!schema) {
      EXPECT_EQ(schema.error().kind, ErrorKind::kStyle);
    }
  }
}

TEST(ParamSchema, MadeInCppObeysTheSameRules) {
  ParamSpec spec;
  spec.name = "size";
  spec.default_value = {2.0};
  spec.range_min = {0.0};
  spec.range_max = {1.0};
  const Error error = error_of(ParamSchema::create({spec}, "brush"));
  EXPECT_EQ(error.kind, ErrorKind::kStyle);
  EXPECT_EQ(error.where, "brush");
  EXPECT_EQ(error.field, "size.default");
  spec.range_max = {4.0};
  LUM_ASSERT_OK(const auto schema, ParamSchema::create({spec}, "brush"));
  EXPECT_EQ(schema->size(), 1);
}

TEST(ParamSpec, TurnsSceneRadiiIntoWorldLengthsAndBack) {
  const auto schema =
      parsed_schema(table("place", "vec3", "[0, 0, 0]", "[-4, 4]", "scale = \"scene\"\nrole = \"position\"\n") +
                    table("reach", "float", "1", "[0, 4]", "scale = \"scene\"\nrole = \"cutoff\"\n") +
                    table("power", "float", "1", "[0, 4]"));
  const SceneFrame frame{Vec3(10.0F, 20.0F, 30.0F), 2.0F};
  EXPECT_EQ((*schema)[0].stored(1, 1.5, frame), 23.0);
  EXPECT_EQ((*schema)[0].written(1, 23.0, frame), 1.5);
  EXPECT_EQ((*schema)[1].stored(0, 1.5, frame), 3.0);
  EXPECT_EQ((*schema)[1].written(0, 3.0, frame), 1.5);
  EXPECT_EQ((*schema)[2].stored(0, 1.5, frame), 1.5);
}

}  // namespace
}  // namespace luminist
