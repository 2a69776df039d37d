#pragma once
// gpu/gl_name.h -- an OpenGL name that has one owner.
#include <epoxy/gl.h>

#include <utility>

namespace luminist {

/// Move-only; Delete is called once for a name that is not 0. The context that made the name must be current then.
template <void (*Delete)(GLuint)>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  ~GlName() {
    if (name_ != 0) Delete(name_);
  }
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GlName(const GlName&) = delete;
  GlName& operator=(const GlName&) = delete;

  [[nodiscard]] GLuint get() const { return name_; }

 private:
  GLuint name_ = 0;
};

}  // namespace luminist
