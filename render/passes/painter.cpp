#include "render/passes/painter.h"

#include <algorithm>
#include <array>

#include "render/passes/painter_parts.h"
#include "render/passes/sane_scene.h"

namespace kaori::passes {
namespace {

using scene::Style;

// In the order in which they are laid: later ones over earlier ones.
constexpr std::array kGroups{Group::kTextured, Group::kFlat, Group::kWire};

constexpr float kPainterWhole = 1 - kPainterUnseen;

// Behind glowing lines the stage is darker.
constexpr float kWireBackdrop = 0.10F;

float WeightOf(const scene::Scene& s, Style style) {
  return s.styles[static_cast<std::size_t>(style)];
}

float WeightOf(const scene::Scene& s, Group group) {
  switch (group) {
    case Group::kTextured:
      return WeightOf(s, Style::kBare) + WeightOf(s, Style::kHair) + WeightOf(s, Style::kSoft);
    case Group::kFlat:
      return WeightOf(s, Style::kFlat);
    case Group::kWire:
      return WeightOf(s, Style::kWire);
  }
  return 0;
}

// The lamps light the backdrop too; no light, no backdrop.
float LightBehind(const scene::Scene& s) {
  return std::min(s.light.exposure, 1.0F);
}

float LightBehind(const scene::Scene& s, Group group) {
  return LightBehind(s) * (group == Group::kWire ? kWireBackdrop : 1.0F);
}

// What all groups show together where there is no figure.
float MixedLightBehind(const scene::Scene& s) {
  return LightBehind(s) * (1 - (1 - kWireBackdrop) * WeightOf(s, Group::kWire) * s.present);
}

// Of the textured styles alone.
float SoftShare(const scene::Scene& s) {
  return WeightOf(s, Style::kSoft) / std::max(WeightOf(s, Group::kTextured), kPainterUnseen);
}
float HairShare(const scene::Scene& s) {
  return 1 - WeightOf(s, Style::kBare) / std::max(WeightOf(s, Group::kTextured), kPainterUnseen);
}

// Of the faces that are shown, the mean of what each has.
float MeanOf(const std::vector<float>& each, const face::Terms& faces) {
  float mean = 0;
  for (const face::Term& term : faces) mean += term.weight * each[term.index];
  return mean < kPainterUnseen ? 0.0F : std::min(mean, 1.0F);
}

// Takes the value of a step that succeeded; else keeps the first error.
template <class T>
void Keep(Result<T> made, std::optional<T>& into, Result<void>& outcome) {
  if (made) {
    into.emplace(std::move(*made));
  } else if (outcome) {
    outcome = tl::unexpected(std::move(made.error()));
  }
}

}  // namespace

Painter::Parts::Parts(const face::Cast& cast, Preparation prepared)
    : painted(&cast),
      composer(std::move(prepared.composer)),
      squeeze(cast.topology),
      neck(NeckOf(cast)),
      necks(cast),
      edges(std::move(prepared.edges)),
      head_fit(std::move(prepared.head_fit)),
      appearance(cast, prepared.props),
      surface(cast, prepared.worn) {
  for (const face::Face& f : cast.faces) {
    prints.push_back(f.surface.print);
    folds.push_back(f.surface.folds);
  }
}

// All are opened, so that all shaders are compiled by the time of the first frame.
Result<void> Painter::Parts::Open(const face::Cast& cast, Quality wanted) {
  Result<void> outcome = SetQuality(wanted);
  Keep(EyesPass::Open(cast.topology), eyes, outcome);
  Keep(LashesPass::Open(cast.topology), lashes, outcome);
  Keep(MouthPass::Open(cast), mouth, outcome);
  Keep(ClothesPass::Open(), clothes, outcome);
  Keep(FlatPass::Open(cast), flat, outcome);
  Keep(WirePass::Open(cast), wire, outcome);
  Keep(HandlesPass::Open(cast), handles, outcome);
  Keep(BackdropPass::Open(cast), backdrop, outcome);
  Keep(CaptionPass::Open(), caption, outcome);
  Keep(LayerPass::Open(), layer, outcome);
  return outcome;
}

// Skins are the same in both qualities, and stay loaded.
Result<void> Painter::Parts::SetQuality(Quality wanted) {
  if (body && wanted == quality) return {};
  auto skin = BodyPass::Open(*painted, wanted);
  if (!skin) return tl::unexpected(skin.error());
  auto locks = HairPass::Open(wanted);
  if (!locks) return tl::unexpected(locks.error());
  std::optional<gl::DepthMap> map;
  std::optional<ScatterPass> spread;
  Result<void> made;
  if (wanted != Quality::kBasic) Keep(gl::DepthMap::Make(kShadowSide_px), map, made);
  if (wanted == Quality::kFinest) Keep(ScatterPass::Open(), spread, made);
  if (!made) return made;
  if (body) skin->AdoptSkins(*body);
  body.emplace(std::move(*skin));
  hair.emplace(std::move(*locks));
  depths = std::move(map);
  scatter = std::move(spread);
  scattered = nullptr;
  quality = wanted;
  return {};
}

// Finer qualities are asked of a processor to see what a graphics card would draw.
gl::Antialiasing Painter::Parts::antialiasing() const {
  return by_processor && quality == Quality::kBasic ? gl::Antialiasing::kSupersample
                                                    : gl::Antialiasing::kMultisample;
}

// As large as at every frame before, so that nothing is allocated.
void Painter::Parts::ComposeAtRest(const face::Weights& weights) {
  face::Weights at_rest;
  at_rest.faces = weights.faces;
  const auto cage = composer.Compose(at_rest, face::Detail::kCage).cage;
  rest.assign(cage.begin(), cage.end());
}

// Front to back, so that what is hidden costs little.
void Painter::Parts::DrawTextured(const scene::Scene& scene, const face::Shape& shape) {
  hair->Draw(appearance, hairdo, block, LampDepths());
  lashes->Draw(shape);
  clothes->Draw(appearance, dressing, block);
  body->Draw(surface, shape, HairShare(scene) > kPainterWhole, LampDepths(), scattered);
  hair->DrawBehind(appearance, hairdo, block, LampDepths());
  eyes->Draw(shape, scene.gaze, scene.pupil);
  mouth->Draw(appearance, shape);
}

// Of 1993: no hair, no lashes; eyes and mouth as ever.
void Painter::Parts::DrawFlat(const scene::Scene& scene, const face::Shape& shape) {
  clothes->Draw(appearance, dressing, block);
  flat->Draw(shape);
  eyes->Draw(shape, scene.gaze, scene.pupil);
  mouth->Draw(appearance, shape);
}

// Dark eyeballs hide the lines behind them.
void Painter::Parts::DrawWire(const scene::Scene& scene, const face::Shape& shape) {
  surface.WriteCage(shape);
  eyes->DrawDark(shape);
  wire->Draw(surface, shape, scene.gaze);
}

void Painter::Parts::DrawGroup(Group group, const scene::Scene& scene, const face::Shape& shape) {
  switch (group) {
    case Group::kTextured:
      return DrawTextured(scene, shape);
    case Group::kFlat:
      return DrawFlat(scene, shape);
    case Group::kWire:
      return DrawWire(scene, shape);
  }
}

// Writes what all shaders of this frame share, and keeps it for what is worked out here.
void Painter::Parts::BindFrame(const scene::Scene& scene, const gl::Canvas& canvas) {
  const Neck worn = dressing.count > 0 ? AboveCollar(neck, dressing.collar_m) : neck;
  block = MakeFrame(scene, worn, canvas, SoftShare(scene));
  frame.Write(std::as_bytes(std::span(&block, 1)));
  frame.BindUniforms(kFrameBinding);
}

Painter::Painter(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Painter::~Painter() = default;

Result<std::unique_ptr<Painter>> Painter::Open(const gl::Context& context, const face::Cast& cast) {
  return Open(context, cast, Preparation(cast));
}

Result<std::unique_ptr<Painter>> Painter::Open(const gl::Context& context, const face::Cast& cast,
                                               Preparation prepared, Quality quality) {
  const std::vector<gl::MipLevel> skin = std::move(prepared.skin);
  const int first_skin = prepared.first_skin;
  auto parts = std::make_unique<Parts>(cast, std::move(prepared));
  parts->by_processor = QualityFor(context.renderer()) == Quality::kBasic;
  if (auto opened = parts->Open(cast, quality); !opened) return tl::unexpected(opened.error());
  if (!skin.empty()) parts->body->Provide(first_skin, skin);
  return std::unique_ptr<Painter>(new Painter(std::move(parts)));
}

// Groups are laid over each other by their part of what is laid so far: the mean of all by their weights.
void Painter::Draw(const scene::Scene& wanted, const gl::Canvas& canvas) {
  Parts& p = *parts_;
  Sane(wanted, p.sane);
  const scene::Scene& scene = p.sane;
  // The other styles need the cage alone.
  const bool fine = WeightOf(scene, Group::kTextured) > kPainterUnseen;
  if (fine && p.depths) p.ComposeAtRest(scene.weights);
  const face::Shape& shape =
      p.composer.Compose(scene.weights, fine ? face::Detail::kFine : face::Detail::kCage);
  p.appearance.Weigh(shape.faces);
  p.dressing = p.necks.Dress(shape.faces);
  p.hairdo.Comb(p.appearance, p.head_fit, shape.faces, HairShare(scene));
  p.BindFrame(scene, canvas);
  const glm::vec2 picture_px(canvas.width_px(), canvas.height_px());
  const FigureRegion figure = FindFigure(p.block, picture_px, shape, p.appearance, p.edges,
                                         {.handles_m = HandlesPass::ReachOf(scene.handles),
                                          .clothes_m = p.dressing.reach_m(),
                                          .hair_m = p.hairdo.reach_m()});
  p.backdrop->Prepare(scene, canvas.width_px(), canvas.height_px());
  const gl::Texture& behind = p.backdrop->picture();
  const std::uint64_t version = p.backdrop->version();
  p.layer->LayBackdropAround(canvas, figure, {behind, version, MixedLightBehind(scene)});
  if (fine) p.surface.WriteFine(shape);
  if (fine && p.depths) {
    p.surface.WriteSqueeze(p.squeeze.Between(p.rest, shape.cage, MeanOf(p.folds, shape.faces)));
    p.DrawShadows();
    p.ScatterLight(shape, canvas, figure.whole);
  }
  const float print = MeanOf(p.prints, shape.faces);
  // Who has left leaves a layer without a figure, by which the others are thinned.
  float laid = 1 - scene.present;
  if (laid > kPainterUnseen) {
    canvas.BeginLayer(figure.bands, figure.whole);
    p.layer->Lay(canvas, figure, {behind, version, LightBehind(scene)},
                 {.opacity = 1, .print = 0, .exposure = scene.light.exposure});
  }
  for (const Group group : kGroups) {
    const float weight = WeightOf(scene, group) * scene.present;
    if (weight <= kPainterUnseen) continue;
    laid += weight;
    canvas.BeginLayer(figure.bands, figure.whole);
    p.DrawGroup(group, scene, shape);
    p.handles->Draw(scene.handles, shape,
                    group == Group::kWire ? HandlesPass::Among::kWires : HandlesPass::Among::kSkin);
    p.layer->Lay(canvas, figure, {behind, version, LightBehind(scene, group)},
                 // The first group replaces, the next ones are blended: w1 / w1, w2 / (w1 + w2), ...
                 {.opacity = weight / laid,
                  .print = group == Group::kTextured ? print : 0,
                  .exposure = scene.light.exposure,
                  .dots = print > 0 ? DotsOn(p.block, picture_px) : glm::vec4(0, 0, 1, 0)});
  }
  p.caption->Draw(scene.caption, canvas);
}

Quality Painter::quality() const {
  return parts_->quality;
}

gl::Antialiasing Painter::antialiasing() const {
  return parts_->antialiasing();
}

// What was warmed up of the body is to be warmed up again.
Result<void> Painter::SetQuality(Quality quality) {
  auto set = parts_->SetQuality(quality);
  if (!set) return set;
  parts_->warmed_up = 0;
  parts_->backstage.reset();
  return set;
}

void Painter::Renew(std::size_t expression) {
  parts_->composer.Renew(expression);
}

const face::Shape& Painter::shape() const {
  return parts_->composer.shape();
}

}  // namespace kaori::passes
