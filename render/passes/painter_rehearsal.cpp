#include "render/passes/painter_parts.h"

namespace kaori::passes {
namespace {

// Two faces, and with them two textures, or four.
face::Weights CrossFade(std::uint16_t faces) {
  face::Weights weights;
  for (std::uint16_t face = 0; face < faces; ++face) weights.faces.Push(face, 1);
  return weights;
}

FigureRegion Everywhere(const gl::Box& whole) {
  FigureRegion figure{.whole = whole};
  figure.bands[0] = whole;
  return figure;
}

}  // namespace

void Painter::Parts::Rehearse(Turn turn) {
  scene::Scene scene;
  scene.weights = CrossFade(turn == Turn::kBody4 ? 4 : 2);
  face::Shape shape = composer.Compose(scene.weights, face::Detail::kFine);
  shape.jaw_drop_m = 0.01F;
  appearance.Weigh(shape.faces);
  surface.WriteFine(shape);
  surface.WriteCage(shape);
  BindFrame(scene, *backstage);
  const gl::Box whole = backstage->whole();
  backstage->BeginLayer({&whole, 1}, whole);
  switch (turn) {
    case Turn::kMouth:
      return mouth->Draw(appearance, shape);
    case Turn::kHair:
      return hair->Draw(appearance, 0.5F);
    case Turn::kClothes:
      return clothes->Draw(appearance, shape.faces);
    case Turn::kBody2:
    case Turn::kBody4:
      return body->Draw(surface, shape, false);
    case Turn::kFlat:
      return flat->Draw(shape);
    case Turn::kDarkEyes:
      return eyes->DrawDark(shape);
    case Turn::kWire:
      return wire->Draw(surface, shape, scene.gaze);
    case Turn::kHandles:
      scene.handles.shown = 1;
      scene.handles.chosen = 0;
      return handles->Draw(scene.handles, shape);
    case Turn::kCaption:
      return caption->Draw({.shown = 1, .lines = {" "}}, *backstage);
    case Turn::kLayer:
      return layer->Lay(*backstage, Everywhere(whole), {backdrop->picture()}, {.opacity = 0.5F});
    case Turn::kPrint:
      return layer->Lay(*backstage, Everywhere(whole), {backdrop->picture()}, {.print = 1});
  }
}

bool Painter::RehearseStep() {
  Parts& p = *parts_;
  if (p.body->LoadNext()) return true;
  constexpr std::size_t kSteps = Parts::kRehearsal.size() + BackdropPass::kRehearsals;
  if (p.rehearsed >= kSteps) return false;
  if (!p.backstage) {
    constexpr int kSize_px = 16;
    auto canvas = gl::Canvas::Make({.width_px = kSize_px, .height_px = kSize_px});
    if (!canvas) return false;
    p.backstage = std::move(*canvas);
  }
  const std::size_t step = p.rehearsed++;
  if (step < Parts::kRehearsal.size())
    p.Rehearse(Parts::kRehearsal[step]);
  else
    p.backdrop->Rehearse(step - Parts::kRehearsal.size());
  if (p.rehearsed < kSteps) return true;
  p.backstage.reset();
  return false;
}

}  // namespace kaori::passes
