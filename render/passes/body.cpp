#include "render/passes/body.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"
#include "render/passes/skin_texture.h"

namespace kaori::passes {
namespace {

// As many as body.frag mixes.
constexpr int kMostTextures = 4;

// The first four textures of the faces in their order, each once, and their weights. Of more, those that come
// last lend no colour.
struct Mixture {
  std::array<int, kMostTextures> textures{};
  glm::vec4 weights{};
  int count = 0;

  // Faces of one texture add up their weights.
  void Add(int texture, float weight) {
    for (int i = 0; i < count; ++i) {
      if (textures[static_cast<std::size_t>(i)] != texture) continue;
      weights[i] += weight;
      return;
    }
    if (count == kMostTextures) return;
    textures[static_cast<std::size_t>(count)] = texture;
    weights[count++] = weight;
  }
};

// Fewer than this much of a face is not seen in the skin's colour.
constexpr float kUnseen = 1.0F / 512;

}  // namespace

Result<void> BodyPass::AddVariant(int textures) {
  auto program = MakeProgram("body.vert", "body.frag", fmt::format("#define TEXTURES {}\n", textures));
  if (!program) return tl::unexpected(program.error());
  Variant& v = variants_[static_cast<std::size_t>(textures / 2)];
  v.program = std::move(*program);
  v.surface = v.program.Find("surface");
  v.weights = v.program.Find("weights");
  for (int i = 0; i < textures; ++i) v.program.BindSampler(fmt::format("texture{}", i).c_str(), i);
  return {};
}

Result<BodyPass> BodyPass::Open(const face::Cast& cast) {
  BodyPass pass;
  for (const int textures : {1, 2, 4}) {
    if (auto added = pass.AddVariant(textures); !added) return tl::unexpected(added.error());
  }
  pass.cast_ = &cast;
  pass.textures_.resize(cast.textures.size());
  for (const face::Face& f : cast.faces) {
    pass.looks_.push_back({f.surface.texture, {f.surface.softness, f.surface.metal}});
  }
  return pass;
}

// Three textures are drawn by the shader of four, the fourth without weight.
const BodyPass::Variant& BodyPass::VariantFor(int textures) const {
  return variants_[static_cast<std::size_t>(textures == 1 ? 0 : (textures == 2 ? 1 : 2))];
}

const gl::Texture& BodyPass::Skin(int texture) {
  const auto index = static_cast<std::size_t>(texture);
  if (textures_[index].id() == 0) textures_[index] = LoadSkin(cast_->textures[index]);
  return textures_[index];
}

bool BodyPass::LoadNext() {
  const auto waits = [&](const Look& look) {
    return textures_[static_cast<std::size_t>(look.texture)].id() == 0;
  };
  const auto next = std::ranges::find_if(looks_, waits);
  if (next == looks_.end()) return false;
  Skin(next->texture);
  return true;
}

// Softness and metal are blended as numbers, paint in the shader.
void BodyPass::Draw(const Surface& surface, const face::Shape& shape, bool dressed) {
  Mixture mixture;
  glm::vec2 answer{};
  for (const face::Term& term : shape.faces) {
    const Look& look = looks_[term.index];
    answer += term.weight * look.surface;
    if (term.weight > kUnseen) mixture.Add(look.texture, term.weight);
  }
  // What was left out leaves its weight to the others.
  mixture.weights /= glm::dot(mixture.weights, glm::vec4(1));
  const Variant& variant = VariantFor(mixture.count);
  const std::span used(mixture.textures.data(), static_cast<std::size_t>(mixture.count));
  for (const int texture : used) Skin(texture);  // Loading one binds it; so all before the first is bound.
  for (unsigned unit = 0; unit < used.size(); ++unit) Skin(used[unit]).Bind(unit);
  gl::Apply({});
  variant.program.Use();
  gl::Program::Set(variant.surface, answer);
  gl::Program::Set(variant.weights, mixture.weights);
  const bool alone = shape.faces.size() == 1;
  (dressed && alone ? surface.fine_worn(shape.faces[0].index) : surface.fine()).Draw();
}

}  // namespace kaori::passes
