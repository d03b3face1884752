// What a painter is made of. For painter.cpp, painter_light.cpp and painter_warm_up.cpp alone.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/face/composer.h"
#include "render/gl/buffer.h"
#include "render/gl/depth_map.h"
#include "render/passes/backdrop.h"
#include "render/passes/body.h"
#include "render/passes/caption.h"
#include "render/passes/clothes.h"
#include "render/passes/dressing.h"
#include "render/passes/eyes.h"
#include "render/passes/figure_region.h"
#include "render/passes/flat.h"
#include "render/passes/frame.h"
#include "render/passes/hair.h"
#include "render/passes/handles.h"
#include "render/passes/lashes.h"
#include "render/passes/layer.h"
#include "render/passes/mouth.h"
#include "render/passes/painter.h"
#include "render/passes/preparation.h"
#include "render/passes/scatter.h"
#include "render/passes/squeeze.h"
#include "render/passes/surface.h"
#include "render/passes/wire.h"

namespace kaori::passes {

// Of the map of the lamp's depths: half a millimetre of the face each texel.
inline constexpr int kShadowSide_px = 1024;

// A quarter of a step of 8 bits: nobody sees what has less weight.
inline constexpr float kPainterUnseen = 1.0F / 1024;

// Styles that share a mesh are mixed in its shaders; the groups are drawn apart, and dissolve as whole
// pictures.
enum class Group : std::uint8_t { kTextured, kFlat, kWire };
// Passes are optional only while Open makes them; afterwards all are there.
struct Painter::Parts {
  // Takes over what was prepared.
  Parts(const face::Cast& cast, Preparation prepared);
  // Opens all passes, and goes on after a fault; the first one is the error.
  Result<void> Open(const face::Cast& cast, Quality quality);
  // Opens what draws in this quality, and changes nothing where that fails.
  Result<void> SetQuality(Quality quality);
  gl::Antialiasing antialiasing() const;
  // Composes the faces of these weights at rest, for the fine quality: what an expression presses is measured from there.
  void ComposeAtRest(const face::Weights& weights);
  // Draws what the key lamp sees into `depths`. For the fine quality, before the layer is begun; the frame is bound.
  void DrawShadows();
  // Draws the light on the skin apart and spreads it, for DrawTextured of the same frame. As DrawShadows, and after it.
  void ScatterLight(const face::Shape& shape, const gl::Canvas& canvas, const gl::Box& figure);
  // Writes and binds the uniforms of a frame.
  void BindFrame(const scene::Scene& scene, const gl::Canvas& canvas);
  // Into the layer that is begun.
  void DrawGroup(Group group, const scene::Scene& scene, const face::Shape& shape);
  // What a fade or a style needs beyond the default look, by shader.
  enum class Shader : std::uint8_t {
    kMouth,
    kHair,
    kClothes,
    kBody2,
    kFlat,
    kDarkEyes,
    kWire,
    kLayer,
    kPrint,
    kHandles,
    kCaption,
    kBody4
  };
  static constexpr std::array kWarmUpOrder{
      Shader::kMouth,    Shader::kHair, Shader::kClothes, Shader::kLayer,   Shader::kBody2,   Shader::kFlat,
      Shader::kDarkEyes, Shader::kWire, Shader::kPrint,   Shader::kHandles, Shader::kCaption, Shader::kBody4};
  // Draws once with this shader on `backstage`, which must be there.
  void WarmUp(Shader shader);
  // Into the layer that is begun; the shape is composed with the detail that the group needs.
  void DrawTextured(const scene::Scene& scene, const face::Shape& shape);
  // As in 1993, with clothes, eyes and mouth.
  void DrawFlat(const scene::Scene& scene, const face::Shape& shape);
  // Lines over a dark body.
  void DrawWire(const scene::Scene& scene, const face::Shape& shape);

  // Borrowed.
  const face::Cast* painted;
  Quality quality = Quality::kBasic;
  // Whether the context draws without a graphics card.
  bool by_processor = false;
  // Of the key lamp; made for the fine quality alone.
  std::optional<gl::DepthMap> depths;
  // Null where the quality is basic.
  const gl::DepthMap* LampDepths() const { return depths ? &*depths : nullptr; }
  // Made for the finest quality alone.
  std::optional<ScatterPass> scatter;
  // Of the frame that is drawn; null where light stays where it falls.
  const ScatterPass* scattered = nullptr;
  face::Composer composer;
  Squeeze squeeze;
  // The cage of the frame's faces without expressions; of the fine quality.
  std::vector<glm::vec3> rest;
  // Of each face, how much of a poster it is, and how deep its wrinkles are.
  std::vector<float> prints, folds;
  // Where the neck bends, from the reference face.
  Neck neck;
  Necks necks;
  // Of the frame that is drawn.
  Dressing dressing;
  LongestEdges edges;
  HeadFit head_fit;
  Appearance appearance;
  // Of the frame that is drawn.
  Hairdo hairdo;
  // The face as composed for this frame.
  Surface surface;
  // The uniforms that all passes share.
  FrameBlock block{};
  gl::Buffer frame{gl::BufferUse::kEachFrame, sizeof(FrameBlock)};
  std::optional<BodyPass> body;
  std::optional<EyesPass> eyes;
  std::optional<LashesPass> lashes;
  std::optional<MouthPass> mouth;
  std::optional<HairPass> hair;
  std::optional<ClothesPass> clothes;
  std::optional<FlatPass> flat;
  std::optional<WirePass> wire;
  std::optional<HandlesPass> handles;
  std::optional<BackdropPass> backdrop;
  std::optional<CaptionPass> caption;
  std::optional<LayerPass> layer;
  // For warming up; gone when all is done.
  std::optional<gl::Canvas> backstage;
  // Steps that are done.
  std::size_t warmed_up = 0;
  // What is drawn.
  scene::Scene sane;
};

}  // namespace kaori::passes
