#include "render/passes/hair.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/common.hpp>

#include "render/gl/draw_state.h"
#include "render/passes/dressing.h"

namespace kaori::passes {
namespace {

// The band of light is the hair's own colour and a little of the lamp's.
constexpr glm::vec3 kGleam{0.16F, 0.10F, 0.065F};
// What of a hair's own colour it mirrors; light hair no more than this, or silver would look like plastic.
constexpr float kOwnGleam = 3.2F;
constexpr float kMostGleam = 0.34F;

float GleamOf(glm::vec3 paint) {
  const float brightest = std::max({paint.x, paint.y, paint.z, kMostGleam / kOwnGleam});
  return kMostGleam / brightest;
}

// Hair below this share is not drawn, and above kWhole it is drawn as it was cut, which is cheaper.
constexpr float kHairGone = 0.004F;
constexpr float kWhole = 0.999F;
// Hair ends this far beyond its length, so that the tips of whole hair are out of the reach of what shortens
// it.
constexpr float kBeyondTips = 1.35F;
// What is gathered sinks into the head so many times as deep as hard things do, so that all of it goes.
constexpr float kGatheredSinks = 2;
// Between the shortest and the longest lock of a cut that grows.
constexpr float kApart = 0.2F;
// The order of hair runs from the one to the other.
constexpr glm::vec3 kCrown_m{0, 0.125F, 0};
constexpr glm::vec3 kTips_m{0, -0.09F, 0};
constexpr int kHairDepthsUnit = 0;

// How much of a cut's length is there, where so much of the faces' weight has hair at all. A tuft that is left on a head
// without hair would look like a horn: the last third goes soon.
float LengthLeft(float haired) {
  return haired * glm::smoothstep(0.15F, 0.5F, haired);
}

template <class Predicate>
bool AnyHair(const Appearance& appearance, std::size_t face, const Predicate& is) {
  return std::ranges::any_of(appearance.worn_by(face), [&](int index) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    return prop.part == face::Part::kHair && is(prop);
  });
}

// Of a face's cut: its colour, and the height of its lowest tip.
struct HairOf {
  glm::vec3 colour{};
  float lowest_m = 1e9F;
};
// The first soft mesh is the cut; others are gathered of it. Without soft hair the lowest tip is far above everything.
HairOf SoftHairOf(const Appearance& appearance, std::size_t face) {
  HairOf hair;
  for (const int index : appearance.worn_by(face)) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kHair || prop.hard) continue;
    hair.colour = prop.paint;
    for (const Slice& slice : prop.slices) hair.lowest_m = std::min(hair.lowest_m, slice.low_m);
    break;
  }
  return hair;
}

}  // namespace

// Two passes over the faces. The first finds how much of the blend has soft hair at all, and its mean colour;
// the second gives each face its part [from, to) of the order from crown to tips, as large as its weight
// among those with hair. The last part ends at 2, so that no strand falls out at the border by rounding. A
// face that is whole needs no motion.
void Hairdo::Comb(const Appearance& appearance, const HeadFit& fit, const face::Terms& faces, float share) {
  const auto is_soft = [](const PropMesh& prop) { return !prop.hard; };
  const auto is_any = [](const PropMesh&) { return true; };
  // The longest hair first.
  const face::Terms sorted =
      InOrder(faces, [&](std::uint16_t face) { return SoftHairOf(appearance, face).lowest_m; });
  float haired = 0;
  glm::vec3 colours{};
  for (const face::Term& t : sorted) {
    if (!AnyHair(appearance, t.index, is_soft)) continue;
    haired += t.weight;
    colours += t.weight * SoftHairOf(appearance, t.index).colour;
  }
  count_ = 0;
  reach_m_ = 0;
  float laid = 0;
  for (const face::Term& t : sorted) {
    if (t.weight < kHairGone || !AnyHair(appearance, t.index, is_any)) continue;
    WornHair& worn = worn_[count_++];
    worn = {.face = t.index, .grown = haired * share, .present = t.weight * share};
    worn.whole = worn.present > kWhole;
    if (AnyHair(appearance, t.index, is_soft)) {
      worn.own = t.weight / haired;
      worn.others = (colours - t.weight * SoftHairOf(appearance, t.index).colour) / haired;
      worn.from = laid / haired;
      laid += t.weight;
      worn.to = laid / haired;
      if (worn.to > kWhole) worn.to = 2;
    }
    if (t.weight > kWhole) continue;
    worn.motion = fit.To(faces, t.index);
    reach_m_ = std::max(reach_m_, HeadFit::Reach_m(worn.motion));
  }
}

// A uniform that a variant does not use is dropped by the compiler; its -1 is accepted by each Set.
Result<HairPass::Variant> HairPass::MakeVariant(std::string defines) {
  auto program = MakeProgram("hair.vert", "hair.frag", std::move(defines));
  if (!program) return tl::unexpected(program.error());
  Variant v;
  v.paint = program->Find("paint");
  v.gleam = program->Find("gleam");
  v.grown = program->Find("grown");
  v.part = program->Find("part");
  v.motion = program->Find("motion");
  v.span = program->Find("span_px");
  program->BindSampler("depths", kHairDepthsUnit);
  v.program = std::move(*program);
  return v;
}

Result<HairPass::Pair> HairPass::MakePair(const std::string& defines) {
  auto whole = MakeVariant(defines);
  if (!whole) return tl::unexpected(whole.error());
  auto growing = MakeVariant(defines + "#define GROWTH\n");
  if (!growing) return tl::unexpected(growing.error());
  return Pair{std::move(*whole), std::move(*growing)};
}

// The basic pair draws depth in either quality.
Result<HairPass> HairPass::Open(Quality quality) {
  HairPass pass;
  auto basic = MakePair("");
  if (!basic) return tl::unexpected(basic.error());
  pass.basic_ = std::move(*basic);
  if (quality == Quality::kBasic) return pass;
  auto fine = MakePair("#define BY_PIXEL\n");
  if (!fine) return tl::unexpected(fine.error());
  pass.fine_ = std::move(*fine);
  return pass;
}

// Fine hair reads the lamp's depths; its strands end in samples that are left out.
HairPass::Way HairPass::Seen(const gl::DepthMap* depths, Locks locks) const {
  if (depths == nullptr) return {basic_, gl::Blend::kReplace, locks};
  depths->Bind(kHairDepthsUnit);
  return {fine_, gl::Blend::kCoverage, locks};
}

void HairPass::Draw(const Appearance& appearance, const Hairdo& hairdo, const FrameBlock& frame,
                    const gl::DepthMap* depths) const {
  DrawBy(Seen(depths, Locks::kBefore), appearance, hairdo, frame);
}

// Hair that changes was drawn whole by Draw: its variant discards, so that it gains nothing by being hidden.
void HairPass::DrawBehind(const Appearance& appearance, const Hairdo& hairdo, const FrameBlock& frame,
                          const gl::DepthMap* depths) const {
  DrawBy(Seen(depths, Locks::kBehind), appearance, hairdo, frame);
}

void HairPass::DrawDepth(const Appearance& appearance, const Hairdo& hairdo, const FrameBlock& frame) const {
  DrawBy({basic_, gl::Blend::kReplace, Locks::kAll}, appearance, hairdo, frame);
}

void HairPass::DrawBy(const Way& way, const Appearance& appearance, const Hairdo& hairdo,
                      const FrameBlock& frame) const {
  const float crown_px = HeightOnLayer_px(frame, kCrown_m, Follows::kHead);
  const float tips_px = HeightOnLayer_px(frame, kTips_m, Follows::kHead);
  const glm::vec2 span_px(crown_px, std::max(crown_px - tips_px, 1.0F));
  for (const WornHair& worn : hairdo.worn()) {
    if (!worn.whole && way.locks == Locks::kBehind) continue;
    gl::Apply({.blend = worn.whole ? way.blend_of_whole : gl::Blend::kCoverage});
    DrawWorn(worn.whole ? way.pair.whole : way.pair.growing, worn.whole ? way.locks : Locks::kAll, appearance,
             worn, span_px);
  }
}

HairPass::Extent HairPass::ExtentOf(const PropMesh& prop, const WornHair& worn, bool is_cut) {
  if (prop.hard) return {{kBeyondTips, 1 - worn.present, 0}, {0, worn.present, 1}};
  if (is_cut) return {{kBeyondTips * LengthLeft(worn.grown), 0, kApart}, {worn.from, worn.to, 0}};
  return {{kBeyondTips, kGatheredSinks * (1 - worn.present), 0}, {0, 2, 0}};
}

void HairPass::DrawWorn(const Variant& variant, Locks locks, const Appearance& appearance,
                        const WornHair& worn, glm::vec2 span_px) {
  variant.program.Use();
  gl::Program::Set(variant.span, span_px);
  gl::Program::Set(variant.motion, std::span<const glm::vec4>(worn.motion));
  bool has_cut = false;
  for (const int index : appearance.worn_by(worn.face)) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kHair) continue;
    const Extent extent = ExtentOf(prop, worn, !has_cut);
    has_cut = has_cut || !prop.hard;
    if (!prop.hard && extent.grown.x < kHairGone) continue;
    const glm::vec3 paint = prop.hard || worn.whole ? prop.paint : worn.own * prop.paint + worn.others;
    gl::Program::Set(variant.paint, paint);
    gl::Program::Set(variant.gleam, paint * GleamOf(paint) + kGleam);
    gl::Program::Set(variant.grown, extent.grown);
    gl::Program::Set(variant.part, extent.part);
    if (locks != Locks::kBehind) prop.mesh.Draw();
    if (locks != Locks::kBefore) prop.behind.Draw();
  }
}

}  // namespace kaori::passes
