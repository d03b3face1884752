// What of a head can be seen from one side: how near to the viewer its surface comes, point by point.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::inspect {

// From where a viewer far away looks: positive yaw looks from the character's left (+X), positive pitch from
// above. Zero is straight from the front. There is no perspective.
struct View {
  float yaw_rad = 0;
  float pitch_rad = 0;
};

// Into the frame of the view: x to the viewer's right, y up, +z towards the viewer; lengths stay. Turned
// about the origin, first by the yaw about Y, then by the pitch about X.
glm::vec3 Turned(const glm::vec3& p, const View& view);
// The same for many; `turned` has as many entries as `points` and may be the same memory.
void TurnAll(std::span<const glm::vec3> points, const View& view, std::span<glm::vec3> turned);

// The square part of the picture's plane that is looked at, from its lower left corner; metres.
struct Window {
  glm::vec2 low_m{};
  float size_m = 0;
};

// The smallest square, from their lower left, that holds all the points, in the plane. Empty for no points;
// else never without size.
Window WindowOver(std::span<const glm::vec3> points);

// A z-buffer: for each pixel the largest z that was drawn. Square, rows from below. Points outside its window
// fall on no pixel. For one thread; many pictures may be drawn side by side.
class DepthPicture {
 public:
  // `pixels`: of a side; more than 0. The window must have a size.
  DepthPicture(const Window& window, int pixels);

  // Draws a triangle of either winding, in the frame of the view. A pixel counts where its middle lies
  // in the triangle; neighbours that share an edge leave no pixel between them. One that is seen edge
  // on draws nothing.
  void Draw(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
  // The front half of a ball, in the frame of the view.
  void DrawBall(const glm::vec3& centre, float radius_m);

  // The nearest to the viewer at a position of the picture's plane, metres along z; a thousand kilometres
  // behind where nothing was drawn, and outside the window. The pixel's value, not mixed with its neighbours.
  float At(const glm::vec2& position) const;
  // Whether nothing was drawn there.
  bool Empty(const glm::vec2& position) const;

  // Of a side.
  int pixels() const { return pixels_; }
  // The position of a pixel's middle, x and y from 0 at the lower left; also of pixels beyond the edges.
  glm::vec2 Middle(int x, int y) const;

 private:
  // Pixels from first to last; none where first > last.
  struct Range {
    int first, last;
  };
  // The pixels along one axis that a stretch touches, within the picture; `origin` is the window's edge.
  Range Span(float low, float high, float origin) const;
  // Must lie within the picture.
  float& Pixel(int x, int y);

  Window window_;
  int pixels_;
  // The side of a pixel.
  float pixel_m_;
  // Row by row, from below.
  std::vector<float> depth_;
};

}  // namespace kaori::inspect
