#include "render/gl/program.h"

#include <GLES3/gl3.h>

#include <glm/gtc/type_ptr.hpp>

#include "render/gl/shader_text.h"

namespace kaori::gl {
namespace {

void DeleteShader(unsigned id) {
  glDeleteShader(id);
}
void DeleteProgram(unsigned id) {
  glDeleteProgram(id);
}

// The driver's log of a shader or of a program; GLES has a pair of functions for each.
template <class GetNumber, class GetText>
std::string DriversLog(unsigned id, GetNumber get_number, GetText get_text) {
  GLint size = 0;
  get_number(id, GL_INFO_LOG_LENGTH, &size);
  std::string log(static_cast<std::size_t>(size), '\0');
  GLsizei written = 0;
  get_text(id, size, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

// Errors: invalid_argument with the driver's log, files by name; those of Assemble.
Result<Handle> Compile(GLenum stage, const ProgramSource& source, std::string_view file) {
  const auto whole = Assemble(source, file);
  if (!whole) return tl::unexpected(whole.error());
  Handle shader(glCreateShader(stage), DeleteShader);
  const char* text = whole->text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint good = 0;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &good);
  if (good != 0) return shader;
  return FailInput(NameFiles(DriversLog(shader.id(), glGetShaderiv, glGetShaderInfoLog), whole->files));
}

}  // namespace

// Shaders are deleted with their handles when this returns; the program keeps what it linked.
Result<Program> Program::Make(const ProgramSource& source) {
  auto vertex = Compile(GL_VERTEX_SHADER, source, source.vertex);
  if (!vertex) return tl::unexpected(vertex.error());
  auto fragment = Compile(GL_FRAGMENT_SHADER, source, source.fragment);
  if (!fragment) return tl::unexpected(fragment.error());
  Handle program(glCreateProgram(), DeleteProgram);
  glAttachShader(program.id(), vertex->id());
  glAttachShader(program.id(), fragment->id());
  glLinkProgram(program.id());
  GLint good = 0;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &good);
  if (good != 0) return Program(std::move(program));
  return FailInput("link " + std::string(source.vertex) + " and " + std::string(source.fragment) + ": " +
                   DriversLog(program.id(), glGetProgramiv, glGetProgramInfoLog));
}

void Program::Use() const {
  glUseProgram(handle_.id());
}

int Program::Find(const char* name) const {
  return glGetUniformLocation(handle_.id(), name);
}

void Program::BindBlock(const char* name, unsigned binding) const {
  const GLuint block = glGetUniformBlockIndex(handle_.id(), name);
  // A block that the compiler dropped is no fault: not every program uses all of it.
  if (block != GL_INVALID_INDEX) glUniformBlockBinding(handle_.id(), block, binding);
}

// GLES 3.0 has no layout(binding): samplers and blocks are bound by name, once, after linking.
void Program::BindSampler(const char* name, int unit) const {
  Use();
  Set(Find(name), unit);
}

void Program::Set(int at, int value) {
  glUniform1i(at, value);
}
void Program::Set(int at, float value) {
  glUniform1f(at, value);
}
void Program::Set(int at, const glm::vec2& value) {
  glUniform2fv(at, 1, glm::value_ptr(value));
}
void Program::Set(int at, const glm::vec3& value) {
  glUniform3fv(at, 1, glm::value_ptr(value));
}
void Program::Set(int at, const glm::vec4& value) {
  glUniform4fv(at, 1, glm::value_ptr(value));
}
void Program::Set(int at, const glm::ivec2& value) {
  glUniform2iv(at, 1, glm::value_ptr(value));
}
void Program::Set(int at, const glm::ivec4& value) {
  glUniform4iv(at, 1, glm::value_ptr(value));
}
void Program::Set(int at, const glm::mat3& value) {
  glUniformMatrix3fv(at, 1, GL_FALSE, glm::value_ptr(value));
}
void Program::Set(int at, std::span<const float> values) {
  glUniform1fv(at, static_cast<GLsizei>(values.size()), values.data());
}
void Program::Set(int at, std::span<const glm::vec4> values) {
  glUniform4fv(at, static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}

}  // namespace kaori::gl
