#include "render/passes/screen.h"

#include "render/gl/context.h"
#include "render/gl/draw_state.h"
#include "render/passes/shader_library.h"

namespace kaori::passes {

// Without the extension codes would be decoded on reading and not coded again on writing.
Result<ScreenPass> ScreenPass::Open() {
  constexpr const char* kCodes = "GL_EXT_texture_sRGB_decode";
  if (!gl::Context::Offers(kCodes)) return Fail(std::errc::not_supported, std::string("find ") + kCodes);
  auto program = gl::Program::Make(
      {.library = ShaderLibrary(), .vertex = "canvas.vert", .fragment = "screen.frag", .defines = {}});
  if (!program) return tl::unexpected(program.error());
  program->BindSampler("picture", 0);
  ScreenPass pass;
  pass.program_ = std::move(*program);
  pass.everywhere_ = gl::Mesh({}, 3);
  return pass;
}

void ScreenPass::Draw(const gl::Canvas& canvas) const {
  gl::Apply({.depth = gl::Depth::kOff});
  program_.Use();
  canvas.BindPictureCodes(0);
  everywhere_.Draw();
}

}  // namespace kaori::passes
