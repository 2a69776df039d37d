#pragma once
// scene/obj_lines.h -- the text of an OBJ or MTL file as a stream that knows its line.
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>

namespace luminist {

/// Hands the text out line by line, so that whoever is called back by the parser can ask where it is.
class ObjLines : public std::streambuf {
 public:
  explicit ObjLines(std::string text) : text_(std::move(text)) {}
  [[nodiscard]] std::size_t number() const { return number_; }  ///< 1 for the first line
  [[nodiscard]] std::string_view line() const { return {eback(), static_cast<std::size_t>(egptr() - eback())}; }

 protected:
  int_type underflow() override {
    if (next_ == text_.size()) return traits_type::eof();
    const std::size_t end = text_.find('\n', next_);
    const std::size_t stop = end == std::string::npos ? text_.size() : end + 1;
    setg(text_.data() + next_, text_.data() + next_, text_.data() + stop);
    next_ = stop;
    ++number_;
    return traits_type::to_int_type(*gptr());
  }

 private:
  std::string text_;
  std::size_t next_ = 0;
  std::size_t number_ = 0;
};

}  // namespace luminist
