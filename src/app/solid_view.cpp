#include "app/solid_view.h"

#include <epoxy/gl.h>

#include <array>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

namespace luminist {
namespace {

constexpr float kBackground = 0.07F;

/// errors kMissing; kStyle with the driver's words.
Result<unsigned> shader_of(const AssetRoots& roots, const char* file, GLenum kind) {
  LUM_TRY(const auto path, roots.find(file));
  LUM_TRY(const std::string body, read_file(path));
  const std::string text = "#version 330 core\n" + body;
  const char* start = text.c_str();
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &start, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::array<char, 512> words{};
  glGetShaderInfoLog(shader, words.size(), nullptr, words.data());
  glDeleteShader(shader);
  return Error{ErrorKind::kStyle, words.data(), path.string(), "", "restore the file"};
}

}  // namespace

SolidView::~SolidView() {
  if (program_ != 0) glDeleteProgram(program_);
  if (vertices_ != 0) glDeleteVertexArrays(1, &vertices_);
  if (buffers_[0] != 0) glDeleteBuffers(3, buffers_);
  if (frame_ != 0) glDeleteFramebuffers(1, &frame_);
  if (color_ != 0) glDeleteTextures(1, &color_);
  if (depth_ != 0) glDeleteRenderbuffers(1, &depth_);
}

Result<void> SolidView::compile(const AssetRoots& roots) {
  if (program_ != 0) return {};
  LUM_TRY(const unsigned vertex, shader_of(roots, "shaders/window/solid.vert", GL_VERTEX_SHADER));
  auto fragment = shader_of(roots, "shaders/window/solid.frag", GL_FRAGMENT_SHADER);
  if (!fragment) {
    glDeleteShader(vertex);
    return std::move(fragment).error();
  }
  program_ = glCreateProgram();
  for (const unsigned shader : {vertex, *fragment}) {
    glAttachShader(program_, shader);
    glDeleteShader(shader);  // it lives as long as the program
  }
  glLinkProgram(program_);
  GLint good = GL_FALSE;
  glGetProgramiv(program_, GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return {};
  glDeleteProgram(std::exchange(program_, 0));
  return Error{ErrorKind::kGl, "the free view cannot be drawn", "shaders/window", "", "restore the files"};
}

Result<void> SolidView::load(const AssetRoots& roots, std::shared_ptr<const SolidScene> solid) {
  LUM_TRY_VOID(compile(roots));
  if (vertices_ == 0) {
    glGenVertexArrays(1, &vertices_);
    glGenBuffers(3, buffers_);
  }
  glBindVertexArray(vertices_);
  const auto points = [&](unsigned buffer, unsigned slot, const std::vector<Vec3>& values) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Vec3)), values.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(slot);
    glVertexAttribPointer(slot, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3), nullptr);
  };
  points(buffers_[0], 0, solid->positions);
  points(buffers_[1], 1, solid->normals);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[2]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(solid->corners.size() * sizeof(std::uint32_t)),
               solid->corners.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
  solid_ = std::move(solid);
  return {};
}

void SolidView::resize(int width, int height) {
  if (width == width_ && height == height_) return;
  if (frame_ == 0) {
    glGenFramebuffers(1, &frame_);
    glGenTextures(1, &color_);
    glGenRenderbuffers(1, &depth_);
  }
  width_ = width;
  height_ = height;
  glBindTexture(GL_TEXTURE_2D, color_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
}

void SolidView::draw(const Camera& camera, int width, int height) {
  if (empty() || width < 1 || height < 1) return;
  resize(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glClearColor(kBackground, kBackground, kBackground, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glUseProgram(program_);
  const Mat4 clip = camera.clip_from_world(static_cast<float>(width) / static_cast<float>(height));
  const Vec3 eye = camera.position();
  glUniformMatrix4fv(glGetUniformLocation(program_, "clip_from_world"), 1, GL_FALSE, glm::value_ptr(clip));
  glUniform3fv(glGetUniformLocation(program_, "eye"), 1, glm::value_ptr(eye));
  const GLint color = glGetUniformLocation(program_, "color");
  glBindVertexArray(vertices_);
  for (const SolidPart& part : solid_->parts) {
    glUniform3fv(color, 1, glm::value_ptr(part.color));
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(part.first * sizeof(std::uint32_t)));
  }
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace luminist
