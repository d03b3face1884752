#include "render/gl/draw_state.h"

#include <GLES3/gl3.h>

namespace kaori::gl {
namespace {

void Switch(GLenum what, bool on) {
  if (on) {
    glEnable(what);
  } else {
    glDisable(what);
  }
}

}  // namespace

// All of it each time: drivers drop what does not change.
void Apply(const DrawState& state) {
  Switch(GL_CULL_FACE, state.cull == Cull::kBack);
  Switch(GL_DEPTH_TEST, state.depth != Depth::kOff);
  // LEQUAL, so that a second pass over the same triangles is drawn.
  glDepthFunc(GL_LEQUAL);
  glDepthMask(state.depth == Depth::kTestAndWrite ? GL_TRUE : GL_FALSE);
  Switch(GL_BLEND, state.blend == Blend::kOver || state.blend == Blend::kBrightest);
  Switch(GL_SAMPLE_ALPHA_TO_COVERAGE, state.blend == Blend::kCoverage);
  glBlendEquation(state.blend == Blend::kBrightest ? GL_MAX : GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  Switch(GL_POLYGON_OFFSET_FILL, state.push_back);
  // Factor and units: enough for lines a pixel wide on triangles seen aslant.
  glPolygonOffset(1.5F, 4.0F);
}

void CutTo(const Box& box) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(box.left_px, box.bottom_px, box.width_px, box.height_px);
}

}  // namespace kaori::gl
