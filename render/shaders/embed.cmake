# Writes OUTPUT, a C++ file that holds the shaders FILES (full paths, separated by |) as text under their names.
string(REPLACE "|" ";" FILES "${FILES}")
set(entries "")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"render/passes/shader_library.h\"

namespace kaori::passes {
namespace {
constexpr gl::ShaderFile kFiles[] = {
${entries}};
}  // namespace
std::span<const gl::ShaderFile> ShaderLibrary() { return kFiles; }
}  // namespace kaori::passes
")
