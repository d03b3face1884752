#include "render/passes/painter_1993.h"

#include <algorithm>
#include <glm/exponential.hpp>
#include <vector>

#include "render/face/composer.h"
#include "render/gl/draw_state.h"
#include "render/passes/eyes.h"
#include "render/passes/frame.h"
#include "render/passes/sane_scene.h"
#include "render/passes/skin_texture.h"
#include "render/passes/surface.h"

namespace kaori::passes {
namespace {

// sRGB's code, nearly; as light.glsl.
glm::vec3 Code(const glm::vec3& light) {
  return glm::pow(light, glm::vec3(1 / 2.2F));
}

}  // namespace

struct Painter1993::Parts {
  Parts(const face::Cast& the_cast, gl::Program the_program, EyesPass the_eyes)
      : cast(the_cast),
        program(std::move(the_program)),
        eyes(std::move(the_eyes)),
        composer(cast),
        neck(NeckOf(cast)),
        surface(cast, {}) {
    for (const face::Texture& t : cast.textures) textures.push_back(LoadSkin(t, SkinTexels::kCodes));
    program.BindSampler("texture0", 0);
  }

  const gl::Texture& TextureOf(const face::Terms& faces) const {
    const auto heaviest = std::ranges::max_element(faces, {}, &face::Term::weight);
    return textures[static_cast<std::size_t>(cast.faces[heaviest->index].surface.texture)];
  }

  const face::Cast& cast;
  gl::Program program;
  EyesPass eyes;
  face::Composer composer;
  Neck neck;
  Surface surface;
  std::vector<gl::Texture> textures;
  gl::Buffer frame{gl::BufferUse::kEachFrame, sizeof(FrameBlock)};
};

Painter1993::Painter1993(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Painter1993::~Painter1993() = default;

Result<std::unique_ptr<Painter1993>> Painter1993::Open(const gl::Context&, const face::Cast& cast) {
  auto program = MakeProgram("plain.vert", "plain.frag");
  if (!program) return tl::unexpected(program.error());
  auto eyes = EyesPass::Open(cast.topology, EyesPass::Onto::kPicture);
  if (!eyes) return tl::unexpected(eyes.error());
  auto parts = std::make_unique<Parts>(cast, std::move(*program), std::move(*eyes));
  return std::unique_ptr<Painter1993>(new Painter1993(std::move(parts)));
}

void Painter1993::Draw(const scene::Scene& wanted, const gl::Canvas& canvas) {
  Parts& p = *parts_;
  const scene::Scene scene = Sane(wanted);
  const face::Shape& shape = p.composer.Compose(scene.weights, face::Detail::kCage);
  const FrameBlock frame = MakeFrame(scene, p.neck, {canvas.width_px(), canvas.height_px()}, 0);
  p.frame.Write(std::as_bytes(std::span(&frame, 1)));
  p.frame.BindUniforms(kFrameBinding);
  p.surface.WriteCage(shape);
  canvas.BeginPlain(Code(0.5F * (scene.backdrop.top + scene.backdrop.bottom)));
  gl::Apply({});
  p.TextureOf(shape.faces).Bind(0);
  p.program.Use();
  p.surface.cage().Draw();
  p.eyes.Draw(shape, scene.gaze);
}

}  // namespace kaori::passes
