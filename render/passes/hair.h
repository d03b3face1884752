// Hair: locks with a band of light, and the hard things that are worn with it.
#pragma once

#include "render/gl/depth_map.h"
#include "render/gl/draw_state.h"
#include "render/gl/program.h"
#include "render/passes/frame.h"
#include "render/passes/head_fit.h"
#include "render/passes/prop_mesh.h"
#include "render/passes/quality.h"

namespace kaori::passes {

// One face's hair in a frame.
struct WornHair {
  std::uint16_t face = 0;
  // Of the order in which hair replaces hair, 0 at the crown .. 1 at the tips: it is seen where the order
  // lies within [from, to), and no other face's is.
  float from = 0;
  float to = 1;
  // 0..1: what is left of its length, where others have none; and of the face's hard things.
  float grown = 1;
  float present = 1;
  // While faces cross-fade, hair is of one colour: `own` times its own, and this of the others.
  float own = 1;
  glm::vec3 others{};
  // It is as it was cut: nothing of the above matters.
  bool whole = true;
  HeadFit::Motion motion{};
};

// All hair of a frame; the longer one is seen from the crown on, so that its ends do not hang in the air.
class Hairdo {
 public:
  // `faces` as composed, sum 1; `share` 0..1: how much of the hair the style shows. Allocates nothing.
  void Comb(const Appearance& appearance, const HeadFit& fit, const face::Terms& faces, float share);

  std::span<const WornHair> worn() const { return {worn_.data(), count_}; }
  // How far hair lies beyond its place at rest.
  float reach_m() const { return reach_m_; }

 private:
  std::array<WornHair, face::Terms::kCapacity> worn_{};
  std::size_t count_ = 0;
  float reach_m_ = 0;
};

// All hair is one kind of mesh, lit by its tangents (Kajiya and Kay 1989), in basic quality in the vertex shader.
class HairPass {
 public:
  // Compiles two variants of one shader, of fine quality two more. Errors: invalid_argument (a shader).
  static Result<HairPass> Open(Quality quality);

  // Hair of two faces shares the picture as clothes do. Where faces have none, hair shortens into the scalp.
  // Samples of pixels are left out (alpha to coverage) instead of blended, so that nothing
  // needs sorting; it therefore needs a layer with samples. `depths` are the key lamp's in this frame; null
  // where the quality is basic.
  // Of hair as it was cut, the locks behind wait for DrawBehind.
  void Draw(const Appearance& appearance, const Hairdo& hairdo, const FrameBlock& frame,
            const gl::DepthMap* depths) const;
  // The rest of it: after the face, which hides the inside of most.
  void DrawBehind(const Appearance& appearance, const Hairdo& hairdo, const FrameBlock& frame,
                  const gl::DepthMap* depths) const;
  // The same into depth alone; its colours are lost.
  void DrawDepth(const Appearance& appearance, const Hairdo& hairdo, const FrameBlock& frame) const;

 private:
  // Whole hair, and hair that grows or gives way: the latter discards samples, which costs more.
  struct Variant {
    gl::Program program;
    int paint = -1;
    int gleam = -1;
    int grown = -1;
    int part = -1;
    int motion = -1;
    int span = -1;
  };
  // Whole hair is seldom anything else; the other is for fades.
  struct Pair {
    Variant whole;
    Variant growing;
  };
  // `defines`: nothing, GROWTH, BY_PIXEL or both.
  static Result<Variant> MakeVariant(std::string defines);
  static Result<Pair> MakePair(const std::string& defines);
  // Of hair as it was cut. Hair that grows or gives way is drawn whole, with those before.
  enum class Locks : std::uint8_t { kAll, kBefore, kBehind };
  // Which variants, how whole hair meets what is there, and what of it.
  struct Way {
    const Pair& pair;
    gl::Blend blend_of_whole = gl::Blend::kReplace;
    Locks locks = Locks::kAll;
  };
  // As a picture wants it: in the quality that these depths ask for.
  Way Seen(const gl::DepthMap* depths, Locks locks) const;
  // All that is worn.
  void DrawBy(const Way& way, const Appearance& appearance, const Hairdo& hairdo,
              const FrameBlock& frame) const;
  // What of a prop is there, as hair.vert and hair.frag want it.
  struct Extent {
    glm::vec3 grown{};
    glm::vec3 part{};
  };
  // The cut shares the picture with that of other faces; what is gathered of it (a bun, pigtails) grows from its tie
  // as its face comes. Hard things do not shorten: they thin out, and are drawn also where hair has gone.
  static Extent ExtentOf(const PropMesh& prop, const WornHair& worn, bool is_cut);
  // One face's hair, and the hard things that are worn with it. `span_px`: where the order of hair begins,
  // and its length.
  static void DrawWorn(const Variant& variant, Locks locks, const Appearance& appearance,
                       const WornHair& worn, glm::vec2 span_px);

  Pair basic_;
  // Of fine quality.
  Pair fine_;
};

}  // namespace kaori::passes
