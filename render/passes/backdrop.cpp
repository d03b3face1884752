#include "render/passes/backdrop.h"

#include <algorithm>

#include <fmt/format.h>

#include "render/gl/draw_state.h"
#include "render/passes/shader_library.h"
#include "render/passes/skin_texture.h"

namespace kaori::passes {
namespace {

// Small enough to be drawn within a frame, and soft when it is enlarged.
constexpr int kDropWidth_px = 384;
constexpr int kDropHeight_px = 216;
// Drops are as wide as most screens; others see less of them.
constexpr float kDropAspect = 16.0F / 9;

// By BackdropKind.
constexpr std::array<const char*, scene::kBackdropKindCount> kShaders{
    "drop_gradient.frag", "drop_studio.frag", "drop_curtain.frag", "drop_night.frag",   "drop_kitchen.frag",
    "drop_pine.frag",     "drop_lights.frag", "drop_rays.frag",    "drop_nursery.frag", "drop_picture.frag"};

// Backdrops have no Frame block, so gl::Program is asked, not MakeProgram.
Result<gl::Program> Make(std::string_view vertex, std::string_view fragment, std::string defines = {}) {
  return gl::Program::Make(
      {.library = ShaderLibrary(), .vertex = vertex, .fragment = fragment, .defines = std::move(defines)});
}

// How much is seen of what has one aspect and covers another, across and up.
glm::vec2 Cover(float seen_aspect, float whole_aspect) {
  return {std::min(seen_aspect / whole_aspect, 1.0F), std::min(whole_aspect / seen_aspect, 1.0F)};
}

bool Same(const scene::FadingBackdrop& a, const scene::FadingBackdrop& b) {
  return a.weight == b.weight && a.backdrop == b.backdrop;
}

}  // namespace

// Uniforms that a kind does not use are -1, which Set accepts.
Result<void> BackdropPass::AddKinds() {
  for (std::size_t i = 0; i < kShaders.size(); ++i) {
    auto program = Make("drop.vert", kShaders[i]);
    if (!program) return tl::unexpected(program.error());
    program->BindSampler("picture", 0);
    kinds_[i] = {.top = program->Find("top"),
                 .bottom = program->Find("bottom"),
                 .glow = program->Find("glow"),
                 .cover = program->Find("cover")};
    kinds_[i].program = std::move(*program);
  }
  return {};
}

// 1, 2 and 4 drops: 1 << i.
Result<void> BackdropPass::AddMixes() {
  for (std::size_t i = 0; i < mixes_.size(); ++i) {
    auto program = Make("canvas.vert", "backdrop_mix.frag", fmt::format("#define DROPS {}\n", 1U << i));
    if (!program) return tl::unexpected(program.error());
    for (int drop = 0; drop < 1 << i; ++drop) program->BindSampler(fmt::format("drop{}", drop).c_str(), drop);
    mixes_[i] = {.weights = program->Find("weights"), .cover = program->Find("cover")};
    mixes_[i].program = std::move(*program);
  }
  return {};
}

// Ten bits a channel for drops: they are enlarged five times, and steps of eight bits would show.
Result<BackdropPass> BackdropPass::Open(const face::Cast& cast) {
  BackdropPass pass;
  pass.cast_ = &cast;
  pass.everywhere_ = gl::Mesh({}, 3);
  pass.pictures_.resize(cast.textures.size());
  if (auto ok = pass.AddKinds(); !ok) return tl::unexpected(ok.error());
  if (auto ok = pass.AddMixes(); !ok) return tl::unexpected(ok.error());
  constexpr gl::TextureOptions kSmall{
      .width_px = kDropWidth_px, .height_px = kDropHeight_px, .texels = gl::Texels::kRgb10};
  for (gl::Target* target : {&pass.small_, &pass.drops_[0].target, &pass.drops_[1].target,
                             &pass.drops_[2].target, &pass.drops_[3].target}) {
    auto made = gl::Target::Make(kSmall);
    if (!made) return tl::unexpected(made.error());
    *target = std::move(*made);
  }
  return pass;
}

// The heaviest first, those without weight last.
BackdropPass::Mixture BackdropPass::MixtureOf(const scene::Scene& scene) {
  Mixture mixture{};
  // What those that fade leave to the backdrop that stays.
  float rest = 1;
  for (std::size_t i = 0; i < scene::kMostFading; ++i) {
    if (scene.fading[i].weight <= 0) continue;
    mixture[i + 1] = scene.fading[i];
    rest -= scene.fading[i].weight;
  }
  mixture[0] = {scene.backdrop, std::max(rest, 0.0F)};
  std::ranges::sort(mixture, std::ranges::greater{}, &scene::FadingBackdrop::weight);
  return mixture;
}

// Makes the whole picture anew where the canvas's size is another; says whether it did. Without memory it has
// no size.
bool BackdropPass::FitWhole(int width_px, int height_px) {
  if (whole_.width_px() == width_px && whole_.height_px() == height_px) return false;
  auto target = gl::Target::Make({.width_px = width_px, .height_px = height_px});
  whole_ = target ? std::move(*target) : gl::Target();
  return true;
}

bool BackdropPass::Has(int picture) const {
  return picture >= 0 && static_cast<std::size_t>(picture) < pictures_.size();
}

// A picture of the show is loaded when it is first drawn, and covers the drop as CSS's `cover` does: cut,
// never stretched.
void BackdropPass::SetPicture(const Kind& kind, int picture) {
  const auto index = static_cast<std::size_t>(picture);
  const face::Texture& held = cast_->textures[index];
  if (pictures_[index].id() == 0) pictures_[index] = LoadSkin(held);
  pictures_[index].Bind(0);
  const float aspect = static_cast<float>(held.width_px) / static_cast<float>(held.height_px);
  gl::Program::Set(kind.cover, Cover(kDropAspect, aspect));
}

// A picture that the show does not have is drawn as a gradient.
void BackdropPass::Draw(const scene::Backdrop& backdrop, Drop& drop) {
  const bool picture = backdrop.kind == scene::BackdropKind::kPicture && Has(backdrop.picture);
  const bool lost = backdrop.kind == scene::BackdropKind::kPicture && !picture;
  const Kind& kind = kinds_[lost ? 0 : static_cast<std::size_t>(backdrop.kind)];
  drop.target.Begin();
  gl::Apply({.depth = gl::Depth::kOff});
  kind.program.Use();
  gl::Program::Set(kind.top, backdrop.top);
  gl::Program::Set(kind.bottom, backdrop.bottom);
  gl::Program::Set(kind.glow, backdrop.glow);
  if (picture) SetPicture(kind, backdrop.picture);
  everywhere_.Draw();
  drop.shows = backdrop;
}

// The drop that shows it; drawn now where none does, over one that `mixture` has no use for.
std::size_t BackdropPass::DropOf(const scene::Backdrop& backdrop, const Mixture& mixture) {
  const auto shows = [&](const Drop& drop) { return drop.shows == backdrop; };
  auto drop = std::ranges::find_if(drops_, shows);
  if (drop == drops_.end()) {
    // There is always one: a mixture has at most as many as there are drops, and this one is not among them.
    drop = std::ranges::find_if(drops_, [&](const Drop& d) {
      return !d.shows || std::ranges::none_of(mixture, [&](const scene::FadingBackdrop& m) {
        return m.weight > 0 && m.backdrop == *d.shows;
      });
    });
    Draw(backdrop, *drop);
  }
  return static_cast<std::size_t>(drop - drops_.begin());
}

// The drops of a mixture by their weights; a single one is given as it is.
const gl::Texture& BackdropPass::MixDrops(const Mixture& mixture) {
  glm::vec4 weights{};
  std::array<std::size_t, kDrops> drops{};
  int count = 0;
  for (const scene::FadingBackdrop& m : mixture) {
    if (m.weight <= 0) continue;
    drops[static_cast<std::size_t>(count)] = DropOf(m.backdrop, mixture);
    weights[count++] = m.weight;
  }
  if (count == 1) return drops_[drops[0]].target.texture();
  // A unit without a drop of its own looks up the first one, with the weight 0.
  for (unsigned unit = 0; unit < kDrops; ++unit) drops_[drops[unit]].target.texture().Bind(unit);
  const Mix& mix = mixes_[count == 2 ? 1 : 2];
  small_.Begin();
  mix.program.Use();
  gl::Program::Set(mix.cover, glm::vec2(1));
  gl::Program::Set(mix.weights, weights);
  everywhere_.Draw();
  return small_.texture();
}

// Onto the whole picture, with dither, for a gradient of 8 bits shows its steps on a dark stage.
void BackdropPass::Enlarge(const gl::Texture& drop) {
  const Mix& enlarge = mixes_.front();
  whole_.Begin();
  drop.Bind(0);
  enlarge.program.Use();
  const float aspect = static_cast<float>(whole_.width_px()) / static_cast<float>(whole_.height_px());
  gl::Program::Set(enlarge.cover, Cover(aspect, kDropAspect));
  everywhere_.Draw();
}

// Compared exactly: a fade changes weights in every frame, a scene at rest in none.
void BackdropPass::Prepare(const scene::Scene& scene, int width_px, int height_px) {
  const Mixture mixture = MixtureOf(scene);
  const bool new_size = FitWhole(width_px, height_px);
  if (!new_size && version_ > 0 && std::ranges::equal(mixture, mixed_, Same)) return;
  mixed_ = mixture;
  ++version_;
  gl::Apply({.depth = gl::Depth::kOff});
  if (whole_.width_px() > 0) Enlarge(MixDrops(mixture));
}

// Kinds first, then the mixes of two and of four.
void BackdropPass::WarmUp(std::size_t number) {
  Drop& drop = drops_.back();
  if (number < kinds_.size()) {
    scene::Backdrop backdrop;
    backdrop.kind = static_cast<scene::BackdropKind>(number);
    Draw(backdrop, drop);
  } else {
    for (unsigned unit = 0; unit < kDrops; ++unit) drops_.front().target.texture().Bind(unit);
    drop.target.Begin();
    gl::Apply({.depth = gl::Depth::kOff});
    mixes_[number - kinds_.size() + 1].program.Use();
    everywhere_.Draw();
  }
  drop.shows.reset();
}

}  // namespace kaori::passes
