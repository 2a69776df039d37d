#pragma once
// tests/support/fixtures.h -- what many tests need.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/result.h"

namespace luminist {

/// How many of so many problems a test does: under sanitizers a twelfth, because each takes many times as long there.
constexpr std::uint64_t fewer_sanitized(std::uint64_t problems) {
#ifdef __SANITIZE_ADDRESS__
  return (problems + 11) / 12;
#else
  return problems;
#endif
}

/// A fresh folder that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// The error of a result that must have failed; fails the test otherwise.
template <class T>
Error error_of(const Result<T>& result) {
  if (result) {
    ADD_FAILURE() << "an error was expected";
    return {};
  }
  return result.error();
}

}  // namespace luminist

/// Declares a variable from a Result, or fails the test with the error's message.
#define LUM_ASSERT_OK(declaration, expression)                                                   \
  auto LUM_CONCAT(lum_ok_, __LINE__) = (expression);                                             \
  ASSERT_TRUE(LUM_CONCAT(lum_ok_, __LINE__)) << LUM_CONCAT(lum_ok_, __LINE__).error().message(); \
  declaration = std::move(LUM_CONCAT(lum_ok_, __LINE__)).value()
#define LUM_EXPECT_OK(expression)                                                \
  do {                                                                           \
    const auto lum_ok = (expression);                                            \
    EXPECT_TRUE(lum_ok.has_value()) << (lum_ok ? "" : lum_ok.error().message()); \
  } while (false)
