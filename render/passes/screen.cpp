#include "render/passes/screen.h"

#include <algorithm>
#include <string>

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

// A buffer that is n pictures old lacks what the last n pictures changed.
void ScreenPass::Draw(const gl::Canvas& canvas, int pictures_ago) {
  std::shift_right(changes_.begin(), changes_.end(), 1);
  changes_.front() = canvas.AcquireDamage();
  known_ = std::min(known_ + 1, kMostKnown);
  gl::Damage lacks(canvas.width_px(), canvas.height_px());
  if (pictures_ago < 1 || pictures_ago > known_) lacks.AddAll();
  for (int n = 0; n < std::min(pictures_ago, known_); ++n) lacks.Add(changes_[static_cast<std::size_t>(n)]);
  gl::Apply({.depth = gl::Depth::kOff});
  program_.Use();
  canvas.BindPictureCodes(0);
  for (const gl::Box& box : lacks.boxes()) {
    if (box.empty()) continue;
    gl::CutTo(box);
    everywhere_.Draw();
  }
}

}  // namespace kaori::passes
