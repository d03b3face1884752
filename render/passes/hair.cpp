#include "render/passes/hair.h"

#include <array>
#include <cmath>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {
namespace {

constexpr int kStripesWidth_px = 256;
constexpr int kStripesHeight_px = 16;

// A repeatable number 0..1 for each cell.
float Chance(int x, int y) {
  auto h = static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U;
  h = (h ^ (h >> 15)) * 0x2C1B3C6DU;
  return static_cast<float>((h ^ (h >> 13)) & 0xFFFFU) / 65535.0F;
}

// Smooth noise that repeats after `cells` across the texture and after its height.
float Noise(int x, int y, int cells) {
  const float place = static_cast<float>(x * cells) / kStripesWidth_px;
  const int cell = static_cast<int>(place);
  float t = place - static_cast<float>(cell);
  t = t * t * (3 - 2 * t);
  const int row = y / 4;
  return std::lerp(Chance(cell, row + 31 * cells), Chance((cell + 1) % cells, row + 31 * cells), t);
}

gl::Texture MakeStripes() {
  std::array<std::uint8_t, kStripesWidth_px * kStripesHeight_px> grey{};
  for (int y = 0; y < kStripesHeight_px; ++y) {
    for (int x = 0; x < kStripesWidth_px; ++x) {
      const float value = 0.45F * Noise(x, y, 24) + 0.35F * Noise(x, y, 64) + 0.20F * Noise(x, y, 128);
      grey[static_cast<std::size_t>(y * kStripesWidth_px + x)] = static_cast<std::uint8_t>(value * 255.0F);
    }
  }
  return gl::Texture({.width_px = kStripesWidth_px,
                      .height_px = kStripesHeight_px,
                      .texels = gl::Texels::kGrey8,
                      .mipmaps = true,
                      .repeat = true},
                     std::as_bytes(std::span(grey)));
}

constexpr float kGone = 0.01F;
constexpr float kWhole = 0.999F;

}  // namespace

Result<HairPass::Variant> HairPass::MakeVariant(std::string defines) {
  auto program = MakeProgram("hair.vert", "hair.frag", std::move(defines));
  if (!program) return tl::unexpected(program.error());
  program->BindSampler("stripes", 0);
  Variant v;
  v.paint = program->Find("paint");
  v.grown = program->Find("grown");
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
  pass.stripes_ = MakeStripes();
  return pass;
}

void HairPass::Draw(const Wardrobe& wardrobe, float share) const {
  stripes_.Bind(0);
  for (std::size_t i = 0; i < wardrobe.meshes().size(); ++i) {
    const PropMesh& prop = wardrobe.meshes()[i];
    const float presence = wardrobe.presence(i) * share;
    if (prop.part == face::Part::kHair && presence > kGone) DrawLocks(prop, presence);
  }
}

void HairPass::DrawLocks(const PropMesh& hair, float presence) const {
  const bool whole = presence > kWhole;
  const Variant& variant = whole ? whole_ : growing_;
  gl::Apply({.blend = whole ? gl::Blend::kReplace : gl::Blend::kCoverage});
  variant.program.Use();
  gl::Program::Set(variant.paint, hair.paint);
  gl::Program::Set(variant.grown, presence * 1.2F);
  hair.mesh.Draw();
}

}  // namespace kaori::passes
