#include "project/document.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace luminist {
namespace {

TEST(Document, AppliesEditsAndTheirReverse) {
  Document document;
  document.set("a", "1");
  const std::string start = document.hash();
  const std::vector<Edit> edits = {{"a", "1", "2"}, {"b", "", "[1,2]"}};
  LUM_EXPECT_OK(document.apply(edits));
  EXPECT_EQ(document.get("a"), "2");
  EXPECT_EQ(document.get("b"), "[1,2]");
  LUM_EXPECT_OK(document.apply(reversed(edits)));
  EXPECT_EQ(document.hash(), start);
  EXPECT_FALSE(document.has("b"));
}

TEST(Document, RefusesEditsThatDoNotFitAndStaysAsItWas) {
  Document document;
  document.set("a", "1");
  const std::string start = document.hash();
  const std::vector<Edit> edits = {{"b", "", "7"}, {"a", "5", "6"}};
  const Error error = error_of(document.apply(edits));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_EQ(error.field, "a");
  EXPECT_EQ(document.hash(), start);
}

TEST(Document, ADifferenceTurnsOneDocumentIntoTheOther) {
  Document from;
  Document to;
  for (const char* path : {"a", "c", "d"}) from.set(path, "1");
  for (const char* path : {"b", "c", "d"}) to.set(path, "1");
  to.set("d", "2");
  const std::vector<Edit> edits = difference(from, to);
  EXPECT_EQ(edits.size(), 3U);
  LUM_EXPECT_OK(from.apply(edits));
  EXPECT_EQ(from.hash(), to.hash());
  EXPECT_TRUE(difference(from, to).empty());
}

TEST(Document, ErasesBelowAPrefixAndNothingElse) {
  Document document;
  for (const char* path : {"lights/key/color", "lights/key/position", "lights/key2/color", "lights"}) {
    document.set(path, "1");
  }
  document.erase_below("lights/key/");
  EXPECT_EQ(document.entries().size(), 2U);
  EXPECT_TRUE(document.has("lights/key2/color"));
}

TEST(Document, HashesTellPathsFromValues) {
  Document one;
  Document other;
  one.set("ab", "1");
  other.set("a", "1");
  EXPECT_NE(one.hash(), other.hash());
  other.set("a", "");
  other.set("ab", "1");
  EXPECT_EQ(one.hash(), other.hash());
}

}  // namespace
}  // namespace luminist
