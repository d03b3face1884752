#include "render/passes/layer.h"

#include <algorithm>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>

#include "render/gl/context.h"
#include "render/gl/draw_state.h"
#include "render/passes/shader_library.h"

namespace kaori::passes {
namespace {

// From dot to dot on the head; few enough to be seen from the last row. Below the pitch they would not be
// dots.
constexpr float kDots_m = 0.0029F;
constexpr float kLeastPitch_px = 3.5F;
// The middle of the face, and how far from there the head's size in the picture is measured.
constexpr glm::vec3 kFace_m{0, 0, 0.06F};
constexpr float kRule_m = 0.1F;

// The layer itself is read from unit 0.
constexpr int kBehindUnit = 1;

// Where shaders cannot read single samples such a layer is resolved first, and edges are blended before they are squared: a
// little darker.
Result<gl::Program> MakeLayer(std::string_view fragment, std::string defines, bool reads_samples) {
  if (reads_samples) defines += "#define SAMPLES\n";
  auto program = gl::Program::Make({.library = ShaderLibrary(),
                                    .vertex = "canvas.vert",
                                    .fragment = fragment,
                                    .defines = std::move(defines),
                                    .reads_samples = reads_samples});
  if (!program) return program;
  program->BindSampler("layer", 0);
  program->BindSampler("behind", kBehindUnit);
  return program;
}

struct Sides {
  gl::Box left, right;
};

// What of `wide` lies left and right of `band`, at the same height; all of it left of an empty one.
Sides Beside(const gl::Box& band, const gl::Box& wide) {
  const int end_px = wide.left_px + wide.width_px;
  if (band.empty()) return {wide, {}};
  const int from_px = std::max(band.left_px + band.width_px, wide.left_px);
  const int to_px = std::min(band.left_px, end_px);
  return {{wide.left_px, band.bottom_px, to_px - wide.left_px, band.height_px},
          {from_px, band.bottom_px, end_px - from_px, band.height_px}};
}

}  // namespace

// As long as the longer of two rules on the head, which turns one of them away at most.
glm::vec4 DotsOn(const FrameBlock& frame, glm::vec2 picture_px) {
  const glm::vec2 half_px = 0.5F * picture_px;
  const auto in_picture_px = [&](glm::vec3 point) {
    return (1.0F + Project(frame, point, Follows::kHead)) * half_px;
  };
  const glm::vec2 middle_px = in_picture_px(kFace_m);
  const glm::vec2 up_px = in_picture_px(kFace_m + glm::vec3(0, kRule_m, 0)) - middle_px;
  const glm::vec2 side_px = in_picture_px(kFace_m + glm::vec3(kRule_m, 0, 0)) - middle_px;
  const float rule_px = std::max({glm::length(up_px), glm::length(side_px), 1.0F});
  const float wave = 2 * std::numbers::pi_v<float> / std::max(rule_px * kDots_m / kRule_m, kLeastPitch_px);
  const glm::vec2 up = up_px / std::max(glm::length(up_px), 1e-3F);
  const glm::vec2 along = glm::vec2(up.x + up.y, up.y - up.x) * std::numbers::sqrt2_v<float> * 0.5F;
  return {middle_px, wave * along};
}

LayerPass::Variant LayerPass::Named(gl::Program program) {
  Variant v;
  v.dim = program.Find("dim");
  v.opacity = program.Find("opacity");
  v.per_pixel = program.Find("per_pixel");
  v.print = program.Find("print");
  v.dots = program.Find("dots");
  v.program = std::move(program);
  return v;
}

// Print is a variant of its own, so that other figures do not pay for its dots.
Result<LayerPass::Pair> LayerPass::MakePair(bool reads_samples) {
  auto plain = MakeLayer("layer.frag", "", reads_samples);
  if (!plain) return tl::unexpected(plain.error());
  auto printed = MakeLayer("layer.frag", "#define PRINT\n", reads_samples);
  if (!printed) return tl::unexpected(printed.error());
  return Pair{Named(std::move(*plain)), Named(std::move(*printed))};
}

Result<LayerPass> LayerPass::Open() {
  auto backdrop = MakeLayer("backdrop.frag", "", false);
  if (!backdrop) return tl::unexpected(backdrop.error());
  auto texels = MakePair(false);
  if (!texels) return tl::unexpected(texels.error());
  LayerPass pass;
  pass.backdrop_ = Named(std::move(*backdrop));
  pass.of_texels_ = std::move(*texels);
  pass.everywhere_ = gl::Mesh({}, 3);
  if (!gl::Context::ReadsSamples()) return pass;
  auto samples = MakePair(true);
  if (!samples) return tl::unexpected(samples.error());
  pass.of_samples_ = std::move(*samples);
  return pass;
}

// One triangle over all, cut to the box by the scissor test.
void LayerPass::Fill(const gl::Canvas& canvas, const gl::Box& box) const {
  if (box.empty()) return;
  canvas.Within(box);
  everywhere_.Draw();
}

void LayerPass::Lay(const gl::Canvas& canvas, const FigureRegion& figure, const Behind& behind,
                    const Laying& laying) const {
  if (figure.whole.empty()) return;
  // First: it may blit, which needs the scissor test off; BeginPicture turns it on again.
  canvas.BindLayer(0, figure.whole);
  const bool replaces = laying.opacity >= 1;
  gl::Apply({.depth = gl::Depth::kOff, .blend = replaces ? gl::Blend::kReplace : gl::Blend::kOver});
  const Pair& pair = canvas.reads_samples() ? of_samples_ : of_texels_;
  const Variant& variant = laying.print > 0 ? pair.printed : pair.plain;
  variant.program.Use();
  behind.picture.Bind(kBehindUnit);
  gl::Program::Set(variant.dim, behind.dim);
  gl::Program::Set(variant.opacity, laying.opacity);
  gl::Program::Set(variant.per_pixel, glm::vec2(canvas.texels_per_pixel()));
  gl::Program::Set(variant.print, glm::vec2(laying.print, laying.exposure));
  gl::Program::Set(variant.dots, laying.dots);
  canvas.BeginPicture();
  for (const gl::Box& band : figure.bands) Fill(canvas, band);
}

bool LayerPass::BackdropIsInPlace(const gl::Canvas& canvas, const Behind& behind) const {
  return canvas.stamp() == gl::Canvas::Stamp{this, frame_} && behind.version == last_version_ &&
         behind.dim == last_dim_;
}

// Where the backdrop is in place from the frame before, only what the last figure covered and this one does
// not is drawn.
void LayerPass::LayBackdropAround(const gl::Canvas& canvas, const FigureRegion& figure,
                                  const Behind& behind) {
  const bool in_place = BackdropIsInPlace(canvas, behind);
  gl::Apply({.depth = gl::Depth::kOff});
  backdrop_.program.Use();
  behind.picture.Bind(kBehindUnit);
  gl::Program::Set(backdrop_.dim, behind.dim);
  canvas.BeginPicture();
  for (std::size_t b = 0; b < figure.bands.size(); ++b) {
    const gl::Box whole{0, figure.bands[b].bottom_px, canvas.width_px(), figure.bands[b].height_px};
    const Sides sides = Beside(figure.bands[b], in_place ? last_figure_.bands[b] : whole);
    Fill(canvas, sides.left);
    Fill(canvas, sides.right);
  }
  last_version_ = behind.version;
  last_dim_ = behind.dim;
  last_figure_ = figure;
  canvas.SetStamp({this, ++frame_});
}

}  // namespace kaori::passes
