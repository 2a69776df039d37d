#pragma once
// base/result.h -- a value or the reason there is none. The names follow std::expected.
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace luminist {

/// Why an operation failed. The number is the exit status of the command line.
enum class ErrorKind {
  kUsage = 2,        ///< the caller's words are off
  kBadContent = 3,   ///< an input was read and makes no sense
  kMissing = 4,      ///< an input is not there
  kUnwritable = 5,   ///< an output cannot be written
  kGl = 6,           ///< OpenGL is missing, too old or lost
  kLimit = 7,        ///< a limit or the memory is exhausted
  kNothingToDo = 8,  ///< no paint, everything locked
  kNumerical = 9,    ///< the solver failed numerically
  kStyle = 10,       ///< a style's manifest or GLSL is wrong
  kProject = 11,     ///< a project is locked or of a newer version
  kChild = 12,       ///< a helper process died
  kCancelled = 130,  ///< the user stopped it
};

/// One failure, as the user should read it.
struct Error {
  ErrorKind kind = ErrorKind::kUsage;
  std::string what;   ///< what is wrong, in one sentence without a full stop
  std::string where;  ///< path, path:line or path:line:column; empty if there is no place
  std::string field;  ///< the key, flag or parameter; may be empty
  std::string hint;   ///< what to do about it; may be empty

  /// "error[E300] where: what (field); hint"
  [[nodiscard]] std::string message() const;
};

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }
  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const& { return std::get<1>(state_); }
  Error&& error() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool has_value() const { return !error_; }
  explicit operator bool() const { return has_value(); }
  const Error& error() const& { return *error_; }
  Error&& error() && { return *std::move(error_); }

 private:
  std::optional<Error> error_;
};

}  // namespace luminist

#define LUM_CONCAT_INNER(a, b) a##b
#define LUM_CONCAT(a, b) LUM_CONCAT_INNER(a, b)

/// LUM_TRY(auto bytes, read_file(path)); declares bytes, or returns the error to the caller.
#define LUM_TRY(declaration, expression)                                                         \
  auto LUM_CONCAT(lum_try_, __LINE__) = (expression);                                            \
  if (!LUM_CONCAT(lum_try_, __LINE__)) return std::move(LUM_CONCAT(lum_try_, __LINE__)).error(); \
  declaration = std::move(LUM_CONCAT(lum_try_, __LINE__)).value() /* NOLINT */

/// The same for a Result<void>.
#define LUM_TRY_VOID(expression)                                                                       \
  do {                                                                                                 \
    if (auto lum_try_result = (expression); !lum_try_result) return std::move(lum_try_result).error(); \
  } while (false)
