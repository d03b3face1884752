#include "render/passes/hair.h"

#include <algorithm>

#include "render/gl/draw_state.h"
#include "render/passes/dressing.h"

namespace kaori::passes {
namespace {

// The band of light is the hair's own colour and a little of the lamp's.
constexpr glm::vec3 kGleam{0.16F, 0.10F, 0.065F};

// Hair below this share is not drawn, and above kWhole it is drawn as it was cut, which is cheaper.
constexpr float kHairGone = 0.004F;
constexpr float kWhole = 0.999F;
// Hair ends this far beyond its length, so that the tips of whole hair are out of the reach of what shortens it.
constexpr float kBeyondTips = 1.35F;
// The order of hair runs from the one to the other.
constexpr glm::vec3 kCrown_m{0, 0.125F, 0};
constexpr glm::vec3 kTips_m{0, -0.09F, 0};
// What is hard stands in the noise of the picture, not in the order of hair.
constexpr float kHardOrder = 1.0F;
constexpr float kHairOrder = 0.3F;

template <class Predicate>
bool AnyHair(const Appearance& appearance, std::size_t face, const Predicate& is) {
  return std::ranges::any_of(appearance.worn_by(face), [&](int index) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    return prop.part == face::Part::kHair && is(prop);
  });
}

}  // namespace

void Hairdo::Comb(const Appearance& appearance, const HeadFit& fit, const face::Terms& faces, float share) {
  const auto is_soft = [](const PropMesh& prop) { return !prop.hard; };
  const auto is_any = [](const PropMesh&) { return true; };
  const face::Terms sorted = InOrderOfCast(faces);
  float haired = 0;
  for (const face::Term& t : sorted) haired += AnyHair(appearance, t.index, is_soft) ? t.weight : 0.0F;
  count_ = 0;
  reach_m_ = 0;
  float laid = 0;
  for (const face::Term& t : sorted) {
    if (t.weight < kHairGone || !AnyHair(appearance, t.index, is_any)) continue;
    WornHair& worn = worn_[count_++];
    worn = {.face = t.index, .grown = haired * share, .present = t.weight * share};
    worn.whole = worn.present > kWhole;
    if (AnyHair(appearance, t.index, is_soft)) {
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
  v.program = std::move(*program);
  return v;
}

Result<HairPass> HairPass::Open() {
  auto whole = MakeVariant("");
  if (!whole) return tl::unexpected(whole.error());
  auto growing = MakeVariant("#define GROWTH\n");
  if (!growing) return tl::unexpected(growing.error());
  HairPass pass;
  pass.whole_ = std::move(*whole);
  pass.growing_ = std::move(*growing);
  return pass;
}

void HairPass::Draw(const Appearance& appearance, const Hairdo& hairdo, const FrameBlock& frame) const {
  const float crown_px = HeightInPicture_px(frame, kCrown_m, Follows::kHead);
  const float tips_px = HeightInPicture_px(frame, kTips_m, Follows::kHead);
  const glm::vec2 span_px(crown_px, std::max(crown_px - tips_px, 1.0F));
  for (const WornHair& worn : hairdo.worn()) DrawWorn(appearance, worn, span_px);
}

void HairPass::DrawWorn(const Appearance& appearance, const WornHair& worn, glm::vec2 span_px) const {
  const Variant& variant = worn.whole ? whole_ : growing_;
  gl::Apply({.blend = worn.whole ? gl::Blend::kReplace : gl::Blend::kCoverage});
  variant.program.Use();
  gl::Program::Set(variant.span, span_px);
  gl::Program::Set(variant.motion, std::span<const glm::vec4>(worn.motion));
  for (const int index : appearance.worn_by(worn.face)) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kHair || (!prop.hard && worn.grown < kHairGone)) continue;
    gl::Program::Set(variant.paint, prop.paint);
    gl::Program::Set(variant.gleam, prop.paint * 3.2F + kGleam);
    gl::Program::Set(variant.grown, glm::vec2(prop.hard ? kBeyondTips : worn.grown * kBeyondTips,
                                              prop.hard ? 1 - worn.present : 0.0F));
    gl::Program::Set(variant.part, prop.hard ? glm::vec3(0, worn.present, kHardOrder)
                                             : glm::vec3(worn.from, worn.to, kHairOrder));
    prop.mesh.Draw();
  }
}

}  // namespace kaori::passes
