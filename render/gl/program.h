// Shaders, compiled and linked; errors name the file and the line. Texts are those of GLES 3 (GLSL ES 3.00),
// or 3.10 where a program reads samples.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "drivers/base/result.h"
#include "render/gl/handle.h"

namespace kaori::gl {

// A shader's text under its file name. Borrowed; texts that the program carries live for ever.
struct ShaderFile {
  std::string_view name;
  std::string_view text;
};

// `library` holds every file that a program or an #include "name" asks for. Texts carry no #version line.
struct ProgramSource {
  // Borrowed during Make.
  std::span<const ShaderFile> library;
  // Names of files of the library.
  std::string_view vertex;
  std::string_view fragment;
  // Lines such as "#define TEXTURES 4\n", before both texts.
  std::string defines = {};
  // Written in the language of GLES 3.1.
  bool reads_samples = false;
};

// On the thread of its context. Uniforms keep their values until they are set again.
class Program {
 public:
  Program() = default;
  // Blocks: a driver may compile for tens of milliseconds now, and more when it first draws with it. Errors:
  //   invalid_argument           a text does not compile or link: "skin.frag:12: ..."
  //   no_such_file_or_directory  the library has no file of a name that was asked for
  static Result<Program> Make(const ProgramSource& source);

  // What is drawn from here on is drawn with it; Set speaks to it.
  void Use() const;
  // Where a uniform lives; -1 where the compiler dropped it, which every Set accepts. Ask once, when opening.
  int Find(const char* name) const;
  // Makes uniform block `name` read binding point `binding`, and sampler `name` read texture unit `unit`.
  // Once, after linking. A name that the compiler dropped is left alone.
  void BindBlock(const char* name, unsigned binding) const;
  void BindSampler(const char* name, int unit) const;

  // Sets a uniform of the program in use; -1 is accepted and does nothing. The type must be the shader's.
  // Arrays are set from their first element; matrices are by columns, as glm has them.
  static void Set(int at, int value);
  static void Set(int at, float value);
  static void Set(int at, const glm::vec2& value);
  static void Set(int at, const glm::vec3& value);
  static void Set(int at, const glm::vec4& value);
  static void Set(int at, const glm::ivec2& value);
  static void Set(int at, const glm::ivec4& value);
  static void Set(int at, const glm::mat3& value);
  static void Set(int at, std::span<const float> values);
  static void Set(int at, std::span<const glm::vec4> values);

 private:
  explicit Program(Handle handle) : handle_(std::move(handle)) {}
  Handle handle_;
};

}  // namespace kaori::gl
