#include "render/passes/painter_parts.h"

namespace kaori::passes {

// By the same shaders as the picture, through the lamp instead of the camera. Borders between faces that cross-fade lie at
// pixels of the picture that is drawn: here of the lamp's.
void Painter::Parts::DrawShadows() {
  FrameBlock by_lamp = block;
  by_lamp.projection = block.lamp;
  by_lamp.sway.z = by_lamp.sway.w = kShadowSide_px;
  frame.Write(std::as_bytes(std::span(&by_lamp, 1)));
  frame.BindUniforms(kFrameBinding);
  depths->Begin();
  hair->DrawDepth(appearance, hairdo, by_lamp);
  clothes->Draw(appearance, dressing, by_lamp);
  body->DrawDepth(surface);
  frame.Write(std::as_bytes(std::span(&block, 1)));
  frame.BindUniforms(kFrameBinding);
}

// Skin of metal is left as it is, and costs nothing. The light on all of the skin is drawn, also where hair and clothes
// will hide it: light comes out from below them, too.
void Painter::Parts::ScatterLight(const face::Shape& shape, const gl::Canvas& canvas, const gl::Box& figure) {
  scattered = nullptr;
  if (!scatter || body->ScatterOf(shape) < kPainterUnseen) return;
  if (!scatter->Begin(canvas.layer_width_px(), canvas.layer_height_px(), canvas.OnLayer(figure))) return;
  body->DrawLight(surface, shape, *depths);
  scatter->Spread();
  scattered = &*scatter;
}

}  // namespace kaori::passes
