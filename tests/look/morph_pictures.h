// Pictures of the default cast between two faces: what of them is figure, with hair and without.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "render/face/cast.h"
#include "render/gl/canvas.h"
#include "render/gl/context.h"
#include "render/passes/painter.h"
#include "tests/look/regions.h"

namespace kaori::tests {

// Between two faces of the cast: the share of the second one, 0..1.
struct Morph {
  std::uint16_t from = 0;
  std::uint16_t to = 0;
  float share = 0;
};

// Draws the cast as it is and without hair, a little turned, as on the sheet of morphs. For one thread.
class MorphPictures {
 public:
  static constexpr int kWidth_px = 160;
  static constexpr int kHeight_px = 180;

  // Loads the pack. Fails the program where that cannot be read or drawn.
  MorphPictures();

  const face::Cast& cast() const { return *haired_; }
  // Where anything covers the backdrop, be it faintly.
  Pixels Figure(const Morph& morph) { return Covered(*with_hair_, morph); }
  // The same of the head, its neck and its clothes alone.
  Pixels Bald(const Morph& morph) { return Covered(*without_, morph); }

 private:
  using Bytes = std::vector<std::uint8_t>;
  Bytes Draw(passes::Painter& painter, const Morph& morph, glm::vec3 backdrop);
  Pixels Covered(passes::Painter& painter, const Morph& morph);

  // Casts outlive their painters.
  std::unique_ptr<face::Cast> haired_, bald_;
  std::unique_ptr<gl::Context> context_;
  std::optional<gl::Canvas> canvas_;
  std::unique_ptr<passes::Painter> with_hair_, without_;
};

}  // namespace kaori::tests
