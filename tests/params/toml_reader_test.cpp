#include "params/toml_reader.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace luminist {
namespace {

TomlValue parsed_toml(std::string_view text) {
  auto document = parse_toml(text, "a.toml", ErrorKind::kStyle);
  EXPECT_TRUE(document) << (document ? "" : document.error().message());
  return document ? *document : TomlValue{};
}

TEST(ParseToml, KeepsEveryValueWithItsPlace) {
  const TomlValue root = parsed_toml("# note\nb = 2\na = [1.5, \"x\"]\n[t]\nyes = true\nday = 2020-02-02\n");
  ASSERT_EQ(root.entries.size(), 3U);
  EXPECT_EQ(root.entries[0].key, "b");  // file order, not the alphabet's
  EXPECT_EQ(root.entries[0].line, 2);
  EXPECT_EQ(root.entries[0].column, 1);
  const TomlValue* a = root.find("a");
  ASSERT_NE(a, nullptr);
  EXPECT_EQ(a->items[1].text, "x");
  EXPECT_EQ(a->items[1].line, 3);
  EXPECT_EQ(a->items[1].column, 11);
  EXPECT_EQ(root.find("t")->find("yes")->number, 1.0);
  EXPECT_EQ(root.find("t")->find("day")->kind, TomlValue::Kind::kDate);
  EXPECT_EQ(root.find("c"), nullptr);
}

TEST(ParseToml, ReportsTheLineOfAFault) {
  const Error error = error_of(parse_toml("a = 1\nb = [1,\n", "a.toml", ErrorKind::kBadContent));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_EQ(error.where, "a.toml:2:9") << error.message();  // where the text ends
}

TEST(ParseToml, RefusesHostileTextWithoutHarm) {
  const std::string deep = "a = " + std::string(100000, '[');
  EXPECT_EQ(error_of(parse_toml(deep, "a.toml", ErrorKind::kStyle)).kind, ErrorKind::kStyle);
  EXPECT_EQ(error_of(parse_toml("a = \"\xff\xfe\"", "a.toml", ErrorKind::kStyle)).kind, ErrorKind::kStyle);
  EXPECT_EQ(error_of(parse_toml(std::string_view("a\0b", 3), "a.toml", ErrorKind::kStyle)).kind, ErrorKind::kStyle);
  EXPECT_EQ(error_of(parse_toml("a = 99999999999999999999", "a.toml", ErrorKind::kStyle)).kind, ErrorKind::kStyle);
}

TEST(TomlReader, ReadsEachKind) {
  const TomlValue root =
      parsed_toml("s = \"x\"\nn = 3\nf = 0.5\ni = -7\nb = true\nl = [\"p\", \"q\"]\n[t]\n[[u]]\n[[u]]\n");
  TomlReader read(root, "a.toml", ErrorKind::kStyle);
  EXPECT_EQ(read.string("s"), "x");
  EXPECT_EQ(read.number("n"), 3.0);
  EXPECT_EQ(read.number("f", 9.0), 0.5);
  EXPECT_EQ(read.integer("i", 0), -7);
  EXPECT_TRUE(read.boolean("b", false));
  EXPECT_EQ(read.strings("l"), (std::vector<std::string>{"p", "q"}));
  EXPECT_NE(read.table("t"), nullptr);
  EXPECT_EQ(read.tables("u").size(), 2U);
  LUM_EXPECT_OK(read.finish());
}

TEST(TomlReader, FallsBackWhereAKeyIsAbsent) {
  const TomlValue root = parsed_toml("");
  TomlReader read(root, "a.toml", ErrorKind::kStyle);
  EXPECT_EQ(read.string("s", "y"), "y");
  EXPECT_EQ(read.number("n", 2.5), 2.5);
  EXPECT_EQ(read.integer("i", 4), 4);
  EXPECT_TRUE(read.boolean("b", true));
  EXPECT_TRUE(read.strings("l").empty());
  EXPECT_TRUE(read.tables("u").empty());
  EXPECT_EQ(read.table("t"), nullptr);
  LUM_EXPECT_OK(read.finish());
}

TEST(TomlReader, KeepsTheFirstMistake) {
  const TomlValue root = parsed_toml("a = 1\nb = \"x\"\n");
  TomlReader read(root, "a.toml", ErrorKind::kStyle);
  (void)read.string("a");
  (void)read.number("b");
  const Error error = error_of(read.finish());
  EXPECT_EQ(error.where, "a.toml:1:5");
  EXPECT_EQ(error.what, "a string is wanted here, not an integer");
}

TEST(TomlReader, PutsAnUnknownKeyBeforeTheOneThatIsMissing) {
  const TomlValue root = parsed_toml("nmae = \"x\"\n");
  TomlReader read(root, "a.toml", ErrorKind::kStyle);
  (void)read.string("name");
  EXPECT_EQ(error_of(read.status()).what, "the key \"name\" is missing");
  const Error error = error_of(read.finish());
  EXPECT_EQ(error.where, "a.toml:1:1");
  EXPECT_EQ(error.hint, "did you mean \"name\"?");
}

TEST(TomlReader, ListsTheValidKeysWhereNoneIsNear) {
  const TomlValue root = parsed_toml("elephant = 1\n");
  TomlReader read(root, "a.toml", ErrorKind::kStyle);
  (void)read.string("doc", "");
  (void)read.number("size", 0.0);
  EXPECT_EQ(error_of(read.finish()).hint, "valid keys are doc, size");
}

TEST(TomlReader, RefusesNumbersThatAreNotFiniteOrTooLarge) {
  const TomlValue root = parsed_toml("a = nan\nb = 5000000000\n");
  TomlReader first(root, "a.toml", ErrorKind::kStyle);
  (void)first.number("a");
  EXPECT_EQ(error_of(first.status()).where, "a.toml:1:5");
  TomlReader second(root, "a.toml", ErrorKind::kStyle);
  (void)second.integer("b", 0);
  EXPECT_EQ(error_of(second.status()).where, "a.toml:2:5");
}

}  // namespace
}  // namespace luminist
