#include "render/passes/painter_parts.h"

namespace kaori::passes {
namespace {

// Two faces, and with them two textures, or four. Faces that do not exist are left out by the composer.
face::Weights CrossFade(std::uint16_t faces) {
  face::Weights weights;
  for (std::uint16_t face = 0; face < faces; ++face) weights.faces.Push(face, 1);
  return weights;
}

// A figure that fills the first band: one rectangle is enough to have the driver finish a shader.
FigureRegion Everywhere(const gl::Box& whole) {
  FigureRegion figure{.whole = whole};
  figure.bands[0] = whole;
  return figure;
}

}  // namespace

// Draws with one shader on a tiny canvas that nobody sees, in a state in which the show may ask for it.
void Painter::Parts::WarmUp(Shader shader) {
  scene::Scene scene;
  scene.weights = CrossFade(shader == Shader::kBody4 ? 4 : 2);
  face::Shape shape = composer.Compose(scene.weights, face::Detail::kFine);
  // A mouth that is open, or MouthPass would draw nothing.
  shape.jaw_drop_m = 0.01F;
  appearance.Weigh(shape.faces);
  dressing = necks.Dress(shape.faces);
  surface.WriteFine(shape);
  surface.WriteCage(shape);
  BindFrame(scene, *backstage);
  if (depths && (shader == Shader::kHair || shader == Shader::kClothes)) {
    // What grows and changes throws other shadows than what is whole, by shaders of their own.
    hairdo.Comb(appearance, head_fit, shape.faces, 0.5F);
    DrawShadows();
  }
  const gl::Box whole = backstage->whole();
  backstage->BeginLayer({&whole, 1}, whole);
  switch (shader) {
    case Shader::kMouth:
      return mouth->Draw(appearance, shape);
    case Shader::kHair:
      hairdo.Comb(appearance, head_fit, shape.faces, 0.5F);
      return hair->Draw(appearance, hairdo, block, LampDepths());
    case Shader::kClothes:
      return clothes->Draw(appearance, dressing, block);
    case Shader::kBody2:
    case Shader::kBody4:
      return body->Draw(surface, shape, false, LampDepths());
    case Shader::kFlat:
      return flat->Draw(shape);
    case Shader::kDarkEyes:
      return eyes->DrawDark(shape);
    case Shader::kWire:
      return wire->Draw(surface, shape, scene.gaze);
    case Shader::kHandles:
      scene.handles.shown = 1;
      scene.handles.chosen = 0;
      return handles->Draw(scene.handles, shape);
    case Shader::kCaption:
      return caption->Draw({.shown = 1, .lines = {" "}}, *backstage);
    case Shader::kLayer:
      return layer->Lay(*backstage, Everywhere(whole), {backdrop->picture()}, {.opacity = 0.5F});
    case Shader::kPrint:
      return layer->Lay(*backstage, Everywhere(whole), {backdrop->picture()}, {.print = 1});
  }
}

// Skins first: they stall longest.
bool Painter::WarmUpStep() {
  Parts& p = *parts_;
  if (p.body->LoadNext()) return true;
  constexpr std::size_t kSteps = Parts::kWarmUpOrder.size() + BackdropPass::kWarmUps;
  if (p.warmed_up >= kSteps) return false;
  if (!p.backstage) {
    constexpr int kSize_px = 16;
    auto canvas =
        gl::Canvas::Make({.width_px = kSize_px, .height_px = kSize_px, .antialiasing = p.antialiasing()});
    if (!canvas) return false;
    p.backstage = std::move(*canvas);
  }
  const std::size_t step = p.warmed_up++;
  if (step < Parts::kWarmUpOrder.size())
    p.WarmUp(Parts::kWarmUpOrder[step]);
  else
    p.backdrop->WarmUp(step - Parts::kWarmUpOrder.size());
  if (p.warmed_up < kSteps) return true;
  p.backstage.reset();
  return false;
}

}  // namespace kaori::passes
