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

class BackdropPass {
 public:
  // Borrows the cast, whose textures are the pictures. Errors: invalid_argument (a shader).
  static Result<BackdropPass> Open(const face::Cast& cast);

  // Makes the picture of what stands behind `scene`, for a canvas of this size, unless it is there. A new
  // size allocates on the graphics driver's side; a show keeps one.
  void Prepare(const scene::Scene& scene, int width_px, int height_px);

  // That picture: square roots of linear light. Black where there is no memory for it.
  const gl::Texture& picture() const { return whole_.texture(); }
  // Changes whenever the picture does.
  std::uint64_t version() const { return version_; }

  // Draws with one of kWarmUps shaders, unseen, so that the driver has finished it. `number` 0 ..
  // kWarmUps - 1.
  static constexpr std::size_t kWarmUps = scene::kBackdropKindCount + 2;
  void WarmUp(std::size_t number);

 private:
  static constexpr std::size_t kDrops = scene::kMostFading + 1;
  using Mixture = std::array<scene::FadingBackdrop, kDrops>;

  // A way of drawing a backdrop, and where its uniforms are.
  struct Kind {
    gl::Program program = {};
    int top = -1, bottom = -1, glow = -1, cover = -1;
  };
  struct Mix {
    gl::Program program = {};
    int weights = -1, cover = -1;
  };
  // A backdrop that is drawn.
  struct Drop {
    gl::Target target;
    std::optional<scene::Backdrop> shows;
  };

  Result<void> AddKinds();
  Result<void> AddMixes();
  // The backdrops of a scene with their weights, the heaviest first; weights sum to 1.
  static Mixture MixtureOf(const scene::Scene& scene);
  // Whether it had to be made anew.
  bool FitWhole(int width_px, int height_px);
  void Draw(const scene::Backdrop& backdrop, Drop& drop);
  // Whether the cast has a picture of this index.
  bool Has(int picture) const;
  void SetPicture(const Kind& kind, int picture);
  // Gives an index of drops_.
  std::size_t DropOf(const scene::Backdrop& backdrop, const Mixture& mixture);
  const gl::Texture& MixDrops(const Mixture& mixture);
  void Enlarge(const gl::Texture& drop);

  const face::Cast* cast_ = nullptr;
  std::array<Kind, scene::kBackdropKindCount> kinds_;
  // Of 1, 2 and 4 drops; the first enlarges.
  std::array<Mix, 3> mixes_;
  gl::Mesh everywhere_;
  std::array<Drop, kDrops> drops_;
  // Those of the cast that were asked for.
  std::vector<gl::Texture> pictures_;
  // Several drops, mixed.
  gl::Target small_;
  gl::Target whole_;
  // What whole_ shows.
  Mixture mixed_{};
  std::uint64_t version_ = 0;
};

}  // namespace kaori::passes
