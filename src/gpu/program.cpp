#include "gpu/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <regex>
#include <string_view>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

namespace luminist {
namespace {

/// Each chunk starts at a multiple of this line number plus one, so that a line of the joined source tells the chunk.
/// (The file argument of `#line` is not reliable.)
constexpr int kLineBase = 10000;
constexpr std::size_t kLogBytes = 4000;
constexpr const char* kVersion = "#version 450 core\n";

/// Line bases [chunks]: a chunk of more than kLineBase lines takes the bases of the next ones as well.
std::vector<int> line_bases(std::span<const SourceChunk> chunks) {
  std::vector<int> bases;
  int next = kLineBase;
  for (const SourceChunk& chunk : chunks) {
    bases.push_back(next);
    const auto lines = static_cast<int>(std::count(chunk.text.begin(), chunk.text.end(), '\n')) + 1;
    next += (lines / kLineBase + 1) * kLineBase;
  }
  return bases;
}

std::string joined(std::span<const SourceChunk> chunks) {
  std::string source = kVersion;
  const std::vector<int> bases = line_bases(chunks);
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    source += fmt::format("#line {}\n{}\n", bases[i] + 1, chunks[i].text);
  }
  return source;
}

/// Where and what of a driver's first error.
struct LogEntry {
  int line = 0;
  int column = 0;  ///< 0: not told
  std::string text;
};

std::optional<LogEntry> first_error(const std::string& whole_log) {
  // The first error is near the start, and std::regex needs stack for every character.
  const std::string log = whole_log.substr(0, kLogBytes);
  // Mesa "0:30012(7): error: text"; NVIDIA "0(30012) : error C1503: text".
  const std::regex mesa(R"((?:^|\n)\d+:(\d+)\((\d+)\): error: ([^\n]*))");
  const std::regex nvidia(R"((?:^|\n)\d+\((\d+)\) : error ([^\n]*))");
  std::smatch match;
  if (std::regex_search(log, match, mesa)) return LogEntry{std::stoi(match[1]), std::stoi(match[2]), match[3]};
  if (std::regex_search(log, match, nvidia)) return LogEntry{std::stoi(match[1]), 0, match[2]};
  return std::nullopt;
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// A shader object that lives until its program is linked.
class Shader {
 public:
  Shader(GLenum stage, std::span<const SourceChunk> chunks) : name_(glCreateShader(stage)) {
    const std::string source = joined(chunks);
    const char* text = source.c_str();
    glShaderSource(name_.get(), 1, &text, nullptr);
    glCompileShader(name_.get());
  }
  [[nodiscard]] GLuint name() const { return name_.get(); }
  [[nodiscard]] bool compiled() const {
    GLint ok = GL_FALSE;
    glGetShaderiv(name(), GL_COMPILE_STATUS, &ok);
    return ok == GL_TRUE;
  }
  [[nodiscard]] std::string log() const {
    GLint length = 0;
    glGetShaderiv(name(), GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(name(), static_cast<GLsizei>(text.size()), &length, text.data());
    text.resize(static_cast<std::size_t>(length));
    return text;
  }

 private:
  static void remove(GLuint name) { glDeleteShader(name); }
  GlName<remove> name_;
};

std::string link_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
  glGetProgramInfoLog(program, static_cast<GLsizei>(text.size()), &length, text.data());
  text.resize(static_cast<std::size_t>(length));
  return text;
}

using Stage = std::pair<GLenum, std::span<const SourceChunk>>;

/// A linked program's name, which the caller owns.
Result<GLuint> build(Device& device, std::span<const Stage> stages, const std::string& label) {
  LUM_TRY_VOID(device.check_errors("prepare " + label));
  std::vector<Shader> shaders;
  for (const auto& [stage, chunks] : stages) {
    shaders.emplace_back(stage, chunks);
    if (!shaders.back().compiled()) return shader_error(chunks, shaders.back().log(), label);
  }
  const GLuint program = glCreateProgram();
  for (const Shader& shader : shaders) glAttachShader(program, shader.name());
  glLinkProgram(program);
  for (const Shader& shader : shaders) glDetachShader(program, shader.name());
  GLint ok = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) {
    glObjectLabel(GL_PROGRAM, program, -1, label.c_str());
    return program;
  }
  const std::string log = link_log(program);
  glDeleteProgram(program);
  return shader_error(stages.back().second, log, label);
}

}  // namespace

Error shader_error(std::span<const SourceChunk> chunks, const std::string& log, const std::string& label) {
  const std::optional<LogEntry> entry = first_error(log);
  if (!entry || entry->line <= kLineBase) {
    const std::string said = log.empty() ? "the driver gives no reason" : first_line(entry ? entry->text : log);
    return {ErrorKind::kStyle, "the shader is refused: " + said, label, "", ""};
  }
  const std::vector<int> bases = line_bases(chunks);
  const auto above = std::upper_bound(bases.begin(), bases.end(), entry->line - 1);
  const auto chunk = static_cast<std::size_t>(above - bases.begin()) - 1;
  std::string where = fmt::format("{}:{}", chunks[chunk].file, entry->line - bases[chunk]);
  if (entry->column > 0) where += fmt::format(":{}", entry->column);
  return {ErrorKind::kStyle, entry->text, where, "", ""};
}

Result<SourceChunk> load_chunk(const AssetRoots& roots, const std::string& relative_path) {
  LUM_TRY(const auto path, roots.find(relative_path));
  LUM_TRY(std::string text, read_file(path));
  return SourceChunk{path.string(), std::move(text)};
}

Result<Program> Program::compute(Device& device, std::span<const SourceChunk> chunks, const std::string& label) {
  const std::array<Stage, 1> stages{Stage{GL_COMPUTE_SHADER, chunks}};
  LUM_TRY(const GLuint name, build(device, stages, label));
  Program program;
  program.name_ = GlName<remove>(name);
  return program;
}

Result<Program> Program::graphics(Device& device, std::span<const SourceChunk> vertex,
                                  std::span<const SourceChunk> fragment, const std::string& label) {
  const std::array<Stage, 2> stages{Stage{GL_VERTEX_SHADER, vertex}, Stage{GL_FRAGMENT_SHADER, fragment}};
  LUM_TRY(const GLuint name, build(device, stages, label));
  Program program;
  program.name_ = GlName<remove>(name);
  return program;
}

// A location of -1 (a uniform that the compiler removed) is ignored by OpenGL.
void Program::set(const char* uniform, int value) {
  glProgramUniform1i(name(), glGetUniformLocation(name(), uniform), value);
}
void Program::set(const char* uniform, unsigned value) {
  glProgramUniform1ui(name(), glGetUniformLocation(name(), uniform), value);
}
void Program::set(const char* uniform, float value) {
  glProgramUniform1f(name(), glGetUniformLocation(name(), uniform), value);
}
void Program::set(const char* uniform, const Vec2& value) {
  glProgramUniform2fv(name(), glGetUniformLocation(name(), uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const Vec3& value) {
  glProgramUniform3fv(name(), glGetUniformLocation(name(), uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const Vec4& value) {
  glProgramUniform4fv(name(), glGetUniformLocation(name(), uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const Mat3& value) {
  glProgramUniformMatrix3fv(name(), glGetUniformLocation(name(), uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, const Mat4& value) {
  glProgramUniformMatrix4fv(name(), glGetUniformLocation(name(), uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::dispatch(Device& device, std::size_t count, std::size_t local_size) const {
  if (count == 0) return;
  const std::size_t groups = (count + local_size - 1) / local_size;
  const std::size_t across = std::min(groups, static_cast<std::size_t>(device.info().max_groups_x));
  const std::size_t down = (groups + across - 1) / across;
  use();
  glDispatchCompute(static_cast<GLuint>(across), static_cast<GLuint>(down), 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT |
                  GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace luminist
