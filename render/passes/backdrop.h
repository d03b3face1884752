// What stands behind the figure. Each backdrop is drawn once, small, when it is called; a picture as large as
// the canvas is made of them when they change, and then only looked up.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/face/cast.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/gl/target.h"
#include "render/scene/scene.h"

namespace kaori::passes {

// Three steps, each done only when its input changes: a kind is drawn onto a drop of 384 x 216 texels; up to
// four drops are mixed by their weights; the mixture is enlarged onto a picture of the canvas's size. A frame
// in which nothing behind the figure changes costs one look-up a pixel.
class BackdropPass {
 public:
  // Borrows the cast, whose textures are the pictures. Compiles thirteen shaders. Errors: invalid_argument (a
  // shader), not_enough_memory (the drops).
  static Result<BackdropPass> Open(const face::Cast& cast);

  // Makes the picture of what stands behind `scene`, for a canvas of this size, unless it is there. Call it
  // before picture() in each frame. A new size allocates on the graphics driver's side, and a picture that
  // is first called is loaded, which takes some 10 ms; a show keeps one size. Changes framebuffer, program
  // and draw state.
  void Prepare(const scene::Scene& scene, int width_px, int height_px);

  // That picture: square roots of linear light, 8 bit, bottom row first. Black where there is no memory for
  // it. Holds until the next Prepare.
  const gl::Texture& picture() const { return whole_.texture(); }
  // Changes whenever the picture does.
  std::uint64_t version() const { return version_; }

  // Draws with one of kWarmUps shaders, unseen, so that the driver has finished it. `number` 0 .. kWarmUps -
  // 1. Uses the last drop, which shows nothing afterwards.
  static constexpr std::size_t kWarmUps = scene::kBackdropKindCount + 2;
  void WarmUp(std::size_t number);

 private:
  // As many as can be seen at once: those that fade, and the one that stays.
  static constexpr std::size_t kDrops = scene::kMostFading + 1;
  // Backdrops and their weights, the heaviest first; weights sum to 1, and those without weight do not count.
  using Mixture = std::array<scene::FadingBackdrop, kDrops>;

  // A way of drawing a backdrop, and where its uniforms are.
  struct Kind {
    gl::Program program = {};
    int top = -1, bottom = -1, glow = -1, cover = -1;
  };
  // A shader that mixes 1, 2 or 4 drops, and where its uniforms are; 3 are drawn by that of 4.
  struct Mix {
    gl::Program program = {};
    int weights = -1, cover = -1;
  };
  // A target for one backdrop, and what it shows; nothing at first.
  struct Drop {
    gl::Target target;
    std::optional<scene::Backdrop> shows;
  };

  // Both compile; errors as Open.
  Result<void> AddKinds();
  Result<void> AddMixes();
  // The backdrops of a scene with their weights, the heaviest first; weights sum to 1.
  static Mixture MixtureOf(const scene::Scene& scene);
  // Whether it had to be made anew.
  bool FitWhole(int width_px, int height_px);
  // Draws it on the drop, over what that showed.
  void Draw(const scene::Backdrop& backdrop, Drop& drop);
  // Whether the cast has a picture of this index.
  bool Has(int picture) const;
  // Binds the cast's texture of this index for the kind, loaded now where it was not yet.
  void SetPicture(const Kind& kind, int picture);
  // The drop that shows the backdrop, as an index of drops_; drawn now where none does.
  std::size_t DropOf(const scene::Backdrop& backdrop, const Mixture& mixture);
  // The mixture, as small as a drop.
  const gl::Texture& MixDrops(const Mixture& mixture);
  // From a drop's size to that of whole_.
  void Enlarge(const gl::Texture& drop);

  // Borrowed.
  const face::Cast* cast_ = nullptr;
  std::array<Kind, scene::kBackdropKindCount> kinds_;
  // Of 1, 2 and 4 drops; the first enlarges.
  std::array<Mix, 3> mixes_;
  // One triangle that covers all; its corners come from gl_VertexID.
  gl::Mesh everywhere_;
  std::array<Drop, kDrops> drops_;
  // Those of the cast that were asked for.
  std::vector<gl::Texture> pictures_;
  // Several drops, mixed.
  gl::Target small_;
  // The picture; without a size where there was no memory.
  gl::Target whole_;
  // What whole_ shows.
  Mixture mixed_{};
  // 0 before the first Prepare.
  std::uint64_t version_ = 0;
};

}  // namespace kaori::passes
