#include "render/passes/body.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"
#include "render/passes/pores.h"
#include "render/passes/skin_texture.h"

namespace kaori::passes {
namespace {

// As many as body.frag mixes.
constexpr std::size_t kMostTextures = 4;

// Behind those of the skins.
constexpr int kDepthsUnit = kMostTextures;
constexpr int kPoresUnit = kDepthsUnit + 1;
constexpr int kScatteredUnit = kPoresUnit + 1;

// The textures of the faces in their order, each once, and their weights.
class Mixture {
 public:
  struct Share {
    int texture = 0;
    float weight = 0;
  };

  // Faces of one texture add up their weights.
  void Add(int texture, float weight) {
    const auto same = std::ranges::find(shares(), texture, &Share::texture);
    if (same != shares().end())
      same->weight += weight;
    else
      shares_[count_++] = {texture, weight};
  }

  // Leaves the heaviest, in their order; of more than the shader mixes the lightest lend no colour.
  void KeepWhatIsMixed() {
    for (; count_ > kMostTextures; --count_) {
      const auto lightest = std::ranges::min_element(shares(), {}, &Share::weight);
      std::move(lightest + 1, shares().end(), lightest);
    }
  }

  std::span<Share> shares() { return std::span(shares_).first(count_); }

  // Of what is mixed, with the sum 1: what was left out leaves its weight to the others.
  glm::vec4 weights() {
    glm::vec4 weights{};
    for (std::size_t i = 0; i < count_; ++i) weights[static_cast<int>(i)] = shares_[i].weight;
    return weights / glm::dot(weights, glm::vec4(1));
  }

 private:
  std::array<Share, face::Terms::kCapacity> shares_{};
  std::size_t count_ = 0;
};

// Of fine_skin.glsl; a program of basic quality has none of them.
void BindFineSamplers(const gl::Program& program) {
  program.BindSampler("depths", kDepthsUnit);
  program.BindSampler("pores", kPoresUnit);
}

// Fewer than this much of a face is not seen in the skin's colour.
constexpr float kUnseen = 1.0F / 512;

}  // namespace

Result<void> BodyPass::AddVariant(int textures, Quality quality) {
  auto program = MakeProgram("body.vert", "body.frag",
                             fmt::format("#define TEXTURES {}\n{}", textures,
                                         quality != Quality::kBasic ? "#define BY_PIXEL\n" : ""));
  if (!program) return tl::unexpected(program.error());
  Variant& v = variants_[static_cast<std::size_t>(textures / 2)];
  v.program = std::move(*program);
  v.surface = v.program.Find("surface");
  v.weights = v.program.Find("weights");
  v.scatter = v.program.Find("scatter");
  for (int i = 0; i < textures; ++i) v.program.BindSampler(fmt::format("texture{}", i).c_str(), i);
  BindFineSamplers(v.program);
  v.program.BindSampler("scattered", kScatteredUnit);
  return {};
}

Result<void> BodyPass::AddFine() {
  auto depth = MakeProgram("body.vert", "depth.frag", "#define BY_PIXEL\n");
  if (!depth) return tl::unexpected(depth.error());
  depth_ = std::move(*depth);
  auto light = MakeProgram("body.vert", "body_light.frag", "#define BY_PIXEL\n");
  if (!light) return tl::unexpected(light.error());
  light_.surface = light->Find("surface");
  BindFineSamplers(*light);
  light_.program = std::move(*light);
  pores_ = MakePores();
  return {};
}

Result<BodyPass> BodyPass::Open(const face::Cast& cast, Quality quality) {
  BodyPass pass;
  for (const int textures : {1, 2, 4}) {
    if (auto added = pass.AddVariant(textures, quality); !added) return tl::unexpected(added.error());
  }
  if (quality != Quality::kBasic) {
    if (auto added = pass.AddFine(); !added) return tl::unexpected(added.error());
  }
  pass.cast_ = &cast;
  pass.textures_.resize(cast.textures.size());
  for (const face::Face& f : cast.faces) {
    pass.looks_.push_back({f.surface.texture, {f.surface.softness, f.surface.metal}});
  }
  return pass;
}

// Three textures are drawn by the shader of four, the fourth without weight.
const BodyPass::Variant& BodyPass::VariantFor(std::size_t textures) const {
  return variants_[textures == 1 ? 0 : (textures == 2 ? 1 : 2)];
}

const gl::Texture& BodyPass::Skin(int texture) {
  const auto index = static_cast<std::size_t>(texture);
  if (textures_[index].id() == 0) textures_[index] = LoadSkin(cast_->textures[index]);
  return textures_[index];
}

void BodyPass::Provide(int texture, const std::vector<gl::MipLevel>& levels) {
  textures_[static_cast<std::size_t>(texture)] = LoadSkin(levels);
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

glm::vec3 BodyPass::AnswerOf(const face::Shape& shape) const {
  glm::vec2 answer{};
  for (const face::Term& term : shape.faces) answer += term.weight * looks_[term.index].surface;
  return {answer, shape.flush};
}

float BodyPass::ScatterOf(const face::Shape& shape) const {
  const glm::vec3 answer = AnswerOf(shape);
  return std::clamp(answer.x * (1 - answer.y), 0.0F, 1.0F);
}

void BodyPass::BindFine(const gl::DepthMap& depths) const {
  depths.Bind(kDepthsUnit);
  pores_.Bind(kPoresUnit);
}

// Softness and metal are blended as numbers, paint in the shader.
void BodyPass::Draw(const Surface& surface, const face::Shape& shape, bool dressed,
                    const gl::DepthMap* depths, const ScatterPass* scattered) {
  Mixture mixture;
  for (const face::Term& term : shape.faces)
    if (term.weight > kUnseen) mixture.Add(looks_[term.index].texture, term.weight);
  mixture.KeepWhatIsMixed();
  const std::span used = mixture.shares();
  const Variant& variant = VariantFor(used.size());
  for (const auto& share : used)
    Skin(share.texture);  // Loading one binds it; so all before the first is bound.
  for (unsigned unit = 0; unit < used.size(); ++unit) Skin(used[unit].texture).Bind(unit);
  if (depths != nullptr) BindFine(*depths);
  if (scattered != nullptr) scattered->Bind(kScatteredUnit);
  gl::Apply({});
  variant.program.Use();
  gl::Program::Set(variant.surface, AnswerOf(shape));
  gl::Program::Set(variant.weights, mixture.weights());
  gl::Program::Set(variant.scatter, scattered != nullptr ? ScatterOf(shape) : 0.0F);
  const bool alone = shape.faces.size() == 1;
  (dressed && alone ? surface.fine_worn(shape.faces[0].index) : surface.fine()).Draw();
}

// Hair and clothes hide nothing here: what they cover is drawn over by them.
void BodyPass::DrawLight(const Surface& surface, const face::Shape& shape, const gl::DepthMap& depths) const {
  BindFine(depths);
  gl::Apply({});
  light_.program.Use();
  gl::Program::Set(light_.surface, AnswerOf(shape));
  surface.fine().Draw();
}

void BodyPass::DrawDepth(const Surface& surface) const {
  gl::Apply({});
  depth_.Use();
  surface.fine().Draw();
}

}  // namespace kaori::passes
