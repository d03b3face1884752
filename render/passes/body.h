// The face's skin: textured, lit a vertex or a pixel at a time; up to four faces share it while they cross-fade.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/depth_map.h"
#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/passes/quality.h"
#include "render/passes/scatter.h"
#include "render/passes/surface.h"

namespace kaori::passes {

// Weights of faces, their positions and normals are blended before (face::Composer); what is left to this
// pass is their paint: up to four textures are mixed by weight in the shader.
class BodyPass {
 public:
  // Borrows the cast. No texture is loaded yet. Errors: invalid_argument (a shader).
  static Result<BodyPass> Open(const face::Cast& cast, Quality quality);

  // Draws the surface's fine mesh (Surface::WriteFine comes before) with the four heaviest textures of
  // Shape::faces, each by its weight. `dressed`: all hair and clothes of the faces are drawn, so
  // that skin beneath need not be. A texture that is not loaded yet is loaded now, which stalls the
  // frame: see LoadNext.
  // `depths` are the key lamp's in this frame; null where the quality is basic. `scattered` is what DrawLight drew of
  // this frame, spread; null where nothing was.
  void Draw(const Surface& surface, const face::Shape& shape, bool dressed, const gl::DepthMap* depths,
            const ScatterPass* scattered = nullptr);
  // How much of the light on the skins of these faces, by weight, is spread within it, 0..1: metal spreads none.
  float ScatterOf(const face::Shape& shape) const;
  // Draws the light on the surface's fine mesh, and how far it lies, into the picture that ScatterPass has begun. Of
  // the fine quality.
  void DrawLight(const Surface& surface, const face::Shape& shape, const gl::DepthMap& depths) const;
  // Draws the surface's fine mesh into depth alone, whole: hair and clothes hide nothing from the lamp that is not
  // theirs to shade. Of the fine quality.
  void DrawDepth(const Surface& surface) const;

  // Loads the cast's texture of this index, of levels that were made before.
  void Provide(int texture, const std::vector<gl::MipLevel>& levels);

  // Takes over what another pass of the same cast has loaded, which can draw nothing afterwards.
  void AdoptSkins(BodyPass& other) { textures_ = std::move(other.textures_); }

  // A skin is loaded when it is first drawn, so that the first face need not wait for the others. This loads
  // one that no face has shown yet; false where none is left. Blocks for 10 to 40 ms; between frames.
  bool LoadNext();

 private:
  // One shader for each number of textures, and where its uniforms are.
  struct Variant {
    gl::Program program;
    int surface = -1;
    int weights = -1;
    int scatter = -1;
  };
  // What of a face's SurfaceLook the shader needs.
  struct Look {
    int texture = 0;
    // Softness, metal.
    glm::vec2 surface{};
  };
  // What the fine quality looks up besides skins.
  void BindFine(const gl::DepthMap& depths) const;
  // Softness and metal of the faces of a shape, by weight, and its flush.
  glm::vec3 AnswerOf(const face::Shape& shape) const;
  // `textures`: 1, 2 or 4.
  Result<void> AddVariant(int textures, Quality quality);
  // What the fine quality needs besides.
  Result<void> AddFine();
  // The shader that draws this many textures, 1 to 4.
  const Variant& VariantFor(std::size_t textures) const;
  // The cast's texture of this index, loaded now where it is not there yet.
  const gl::Texture& Skin(int texture);

  // For 1, 2 and 4 textures.
  std::array<Variant, 3> variants_;
  const face::Cast* cast_ = nullptr;
  // Of the cast; without an id until they are loaded.
  std::vector<gl::Texture> textures_;
  // One for each face.
  std::vector<Look> looks_;
  // Of the fine quality.
  gl::Program depth_;
  Variant light_;
  gl::Texture pores_;
};

}  // namespace kaori::passes
