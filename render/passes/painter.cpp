#include "render/passes/painter.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "render/face/composer.h"
#include "render/gl/buffer.h"
#include "render/passes/backdrop.h"
#include "render/passes/body.h"
#include "render/passes/clothes.h"
#include "render/passes/eyes.h"
#include "render/passes/figure_region.h"
#include "render/passes/flat.h"
#include "render/passes/frame.h"
#include "render/passes/hair.h"
#include "render/passes/lashes.h"
#include "render/passes/layer.h"
#include "render/passes/mouth.h"
#include "render/passes/needles.h"
#include "render/passes/sane_scene.h"
#include "render/passes/surface.h"
#include "render/passes/wire.h"

namespace kaori::passes {
namespace {

using scene::Style;

// Styles that share a mesh are mixed in its shaders; the groups are drawn apart, and dissolve as whole
// pictures.
enum class Group : std::uint8_t { kTextured, kFlat, kWire };
constexpr std::array kGroups{Group::kTextured, Group::kFlat, Group::kWire};

constexpr float kUnseen = 1.0F / 1024;
constexpr float kWhole = 1 - kUnseen;

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
  return LightBehind(s) * (1 - (1 - kWireBackdrop) * WeightOf(s, Group::kWire));
}

// Of the textured styles alone.
float SoftShare(const scene::Scene& s) {
  return WeightOf(s, Style::kSoft) / std::max(WeightOf(s, Group::kTextured), kUnseen);
}
float HairShare(const scene::Scene& s) {
  return 1 - WeightOf(s, Style::kBare) / std::max(WeightOf(s, Group::kTextured), kUnseen);
}

std::vector<float> PrintsOf(const face::Cast& cast) {
  std::vector<float> prints;
  for (const face::Face& f : cast.faces) prints.push_back(f.surface.print);
  return prints;
}

// Of the faces that are shown, the part that is a poster's print.
float PrintShare(const std::vector<float>& prints, const face::Terms& faces) {
  float share = 0;
  for (const face::Term& term : faces) share += term.weight * prints[term.index];
  return share < kUnseen ? 0.0F : std::min(share, 1.0F);
}

// Takes the value of a step that succeeded; else keeps the first error.
template <class T>
void Take(Result<T> made, std::optional<T>& into, Result<void>& outcome) {
  if (made) {
    into.emplace(std::move(*made));
  } else if (outcome) {
    outcome = tl::unexpected(std::move(made.error()));
  }
}

}  // namespace

struct Painter::Parts {
  explicit Parts(const face::Cast& cast)
      : composer(cast),
        prints(PrintsOf(cast)),
        neck(NeckOf(cast)),
        edges(MeasureEdges(cast)),
        wardrobe(cast),
        surface(cast) {}

  Result<void> Open(const face::Cast& cast);
  FrameBlock BindFrame(const scene::Scene& scene, const gl::Canvas& canvas);
  void DrawGroup(Group group, const scene::Scene& scene, const face::Shape& shape);
  // What a fade or a style needs beyond the default look, by shader.
  enum class Turn : std::uint8_t {
    kMouth,
    kHair,
    kClothes,
    kBody2,
    kFlat,
    kDarkEyes,
    kWire,
    kLayer,
    kPrint,
    kNeedles,
    kBody4
  };
  static constexpr std::array kRehearsal{Turn::kMouth, Turn::kHair,    Turn::kClothes,  Turn::kLayer,
                                         Turn::kBody2, Turn::kFlat,    Turn::kDarkEyes, Turn::kWire,
                                         Turn::kPrint, Turn::kNeedles, Turn::kBody4};
  void Rehearse(Turn turn);
  void DrawTextured(const scene::Scene& scene, const face::Shape& shape);
  void DrawFlat(const scene::Scene& scene, const face::Shape& shape);
  void DrawWire(const scene::Scene& scene, const face::Shape& shape);

  face::Composer composer;
  std::vector<float> prints;  // Of each face, how much of a poster it is.
  Neck neck;
  LongestEdges edges;
  Wardrobe wardrobe;
  Surface surface;
  gl::Buffer frame{gl::BufferUse::kEachFrame, sizeof(FrameBlock)};
  std::optional<BodyPass> body;
  std::optional<EyesPass> eyes;
  std::optional<LashesPass> lashes;
  std::optional<MouthPass> mouth;
  std::optional<HairPass> hair;
  std::optional<ClothesPass> clothes;
  std::optional<FlatPass> flat;
  std::optional<WirePass> wire;
  std::optional<NeedlesPass> needles;
  std::optional<BackdropPass> backdrop;
  std::optional<LayerPass> layer;
  std::optional<gl::Canvas> backstage;
  std::size_t rehearsed = 0;
  scene::Scene sane;  // What is drawn.
};

Result<void> Painter::Parts::Open(const face::Cast& cast) {
  Result<void> outcome;
  Take(BodyPass::Open(cast), body, outcome);
  Take(EyesPass::Open(cast.topology), eyes, outcome);
  Take(LashesPass::Open(cast.topology), lashes, outcome);
  Take(MouthPass::Open(cast), mouth, outcome);
  Take(HairPass::Open(), hair, outcome);
  Take(ClothesPass::Open(), clothes, outcome);
  Take(FlatPass::Open(cast), flat, outcome);
  Take(WirePass::Open(cast), wire, outcome);
  Take(NeedlesPass::Open(cast), needles, outcome);
  Take(BackdropPass::Open(cast), backdrop, outcome);
  Take(LayerPass::Open(), layer, outcome);
  return outcome;
}

// Front to back, so that what is hidden costs little.
void Painter::Parts::DrawTextured(const scene::Scene& scene, const face::Shape& shape) {
  surface.WriteFine(shape);
  hair->Draw(wardrobe, HairShare(scene));
  lashes->Draw(shape);
  clothes->Draw(wardrobe, shape.faces);
  body->Draw(surface, shape, HairShare(scene) > kWhole);
  eyes->Draw(shape, scene.gaze);
  mouth->Draw(wardrobe, shape);
}

void Painter::Parts::DrawFlat(const scene::Scene& scene, const face::Shape& shape) {
  clothes->Draw(wardrobe, shape.faces);
  flat->Draw(shape);
  eyes->Draw(shape, scene.gaze);
  mouth->Draw(wardrobe, shape);
}

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

FrameBlock Painter::Parts::BindFrame(const scene::Scene& scene, const gl::Canvas& canvas) {
  const FrameBlock block = MakeFrame(scene, neck, {canvas.width_px(), canvas.height_px()}, SoftShare(scene));
  frame.Write(std::as_bytes(std::span(&block, 1)));
  frame.BindUniforms(kFrameBinding);
  return block;
}

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

void Painter::Parts::Rehearse(Turn turn) {
  scene::Scene scene;
  scene.weights = CrossFade(turn == Turn::kBody4 ? 4 : 2);
  face::Shape shape = composer.Compose(scene.weights, face::Detail::kFine);
  shape.jaw_drop_m = 0.01F;
  wardrobe.Weigh(shape.faces);
  surface.WriteFine(shape);
  surface.WriteCage(shape);
  BindFrame(scene, *backstage);
  const gl::Box whole = backstage->whole();
  backstage->BeginLayer({&whole, 1}, whole);
  switch (turn) {
    case Turn::kMouth:
      return mouth->Draw(wardrobe, shape);
    case Turn::kHair:
      return hair->Draw(wardrobe, 0.5F);
    case Turn::kClothes:
      return clothes->Draw(wardrobe, shape.faces);
    case Turn::kBody2:
    case Turn::kBody4:
      return body->Draw(surface, shape, false);
    case Turn::kFlat:
      return flat->Draw(shape);
    case Turn::kDarkEyes:
      return eyes->DrawDark(shape);
    case Turn::kWire:
      return wire->Draw(surface, shape, scene.gaze);
    case Turn::kNeedles:
      return needles->Draw({.shown = 1}, shape);
    case Turn::kLayer:
      return layer->Lay(*backstage, Everywhere(whole), {backdrop->picture()}, {.opacity = 0.5F});
    case Turn::kPrint:
      return layer->Lay(*backstage, Everywhere(whole), {backdrop->picture()}, {.print = 1});
  }
}

Painter::Painter(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Painter::~Painter() = default;

Result<std::unique_ptr<Painter>> Painter::Open(const gl::Context&, const face::Cast& cast) {
  auto parts = std::make_unique<Parts>(cast);
  if (auto opened = parts->Open(cast); !opened) return tl::unexpected(opened.error());
  return std::unique_ptr<Painter>(new Painter(std::move(parts)));
}

void Painter::Draw(const scene::Scene& wanted, const gl::Canvas& canvas) {
  Parts& p = *parts_;
  Sane(wanted, p.sane);
  const scene::Scene& scene = p.sane;
  const bool fine = WeightOf(scene, Group::kTextured) > kUnseen;
  const face::Shape& shape =
      p.composer.Compose(scene.weights, fine ? face::Detail::kFine : face::Detail::kCage);
  p.wardrobe.Weigh(shape.faces);
  const FrameBlock frame = p.BindFrame(scene, canvas);
  const FigureRegion figure =
      FindFigure(frame, shape, p.wardrobe, p.edges, NeedlesPass::ReachOf(scene.needles));
  p.backdrop->Prepare(scene, canvas.width_px(), canvas.height_px());
  const gl::Texture& behind = p.backdrop->picture();
  const std::uint64_t version = p.backdrop->version();
  p.layer->LayBackdropAround(canvas, figure, {behind, version, MixedLightBehind(scene)});
  const float print = PrintShare(p.prints, shape.faces);
  float laid = 0;
  for (const Group group : kGroups) {
    const float weight = WeightOf(scene, group);
    if (weight <= kUnseen) continue;
    laid += weight;
    canvas.BeginLayer(figure.bands, figure.whole);
    p.DrawGroup(group, scene, shape);
    p.needles->Draw(scene.needles, shape,
                    group == Group::kWire ? NeedlesPass::Among::kWires : NeedlesPass::Among::kSkin);
    p.layer->Lay(canvas, figure, {behind, version, LightBehind(scene, group)},
                 {.opacity = weight / laid,
                  .print = group == Group::kTextured ? print : 0,
                  .exposure = scene.light.exposure});
  }
}

void Painter::Renew(std::size_t expression) {
  parts_->composer.Renew(expression);
}

const face::Shape& Painter::shape() const {
  return parts_->composer.shape();
}

bool Painter::RehearseStep() {
  Parts& p = *parts_;
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
