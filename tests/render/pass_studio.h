// A context, a painter of the synthetic cast and a canvas, for tests that look at pictures.
#pragma once

#include <memory>
#include <vector>

#include "render/passes/painter.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {

struct Picture {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> bytes;  // R, G, B, X; the bottom row first.

  const std::uint8_t* at(int x_px, int y_px) const {
    return &bytes[static_cast<std::size_t>((y_px * width_px + x_px) * 4)];
  }
};

// Mean difference of the colours, 0..255.
double Difference(const Picture& a, const Picture& b);

// One for all tests of a program: opening takes a quarter of a second.
class PassStudio {
 public:
  static PassStudio& Shared();

  // On a canvas of its own; or on one that has been drawn on before.
  Picture Draw(const scene::Scene& scene, int width_px = 160, int height_px = 120);
  Picture DrawOn(const gl::Canvas& canvas, const scene::Scene& scene);
  const face::Cast& cast() const { return cast_; }
  const gl::Context& context() const { return *context_; }
  passes::Painter& painter() { return *painter_; }

 private:
  PassStudio();

  face::Cast cast_;
  std::unique_ptr<gl::Context> context_;
  std::unique_ptr<passes::Painter> painter_;
};

// The reference face, neutral, in one style.
scene::Scene PlainScene(scene::Style style);

}  // namespace kaori::tests
