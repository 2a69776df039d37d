#include "app/style_parts.h"

#include <gtest/gtest.h>

namespace luminist {
namespace {

TEST(StyleParts, AStackIsNamedByItsParts) {
  EXPECT_EQ(parts_of("toon").base, "toon");
  EXPECT_EQ(parts_of("toon").lines, "");
  EXPECT_EQ(parts_of("toon+outline").base, "toon");
  EXPECT_EQ(parts_of("toon+outline").lines, "outline");
}

TEST(StyleParts, WhatIsTakenApartIsPutTogetherAgain) {
  for (const char* name : {"toon", "toon+outline"}) EXPECT_EQ(parts_of(name).name(), name);
}

}  // namespace
}  // namespace luminist
