// What of a head can be seen from one side: how near to the viewer its surface comes, point by point.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::inspect {

// From where a viewer far away looks: positive yaw looks from the character's left, positive pitch from
// above.
struct View {
  float yaw_rad = 0;
  float pitch_rad = 0;
};

// Into the frame of the view: +z towards the viewer.
glm::vec3 Turned(const glm::vec3& p, const View& view);
void TurnAll(std::span<const glm::vec3> points, const View& view, std::span<glm::vec3> turned);

// The square part of the picture's plane that is looked at.
struct Window {
  glm::vec2 low_m{};
  float size_m = 0;
};

// Holds all the points, in the plane.
Window WindowOver(std::span<const glm::vec3> points);

class DepthPicture {
 public:
  DepthPicture(const Window& window, int pixels);

  // Points in the frame of the view.
  void Draw(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
  void DrawBall(const glm::vec3& centre, float radius_m);

  // The nearest to the viewer at a position of the picture's plane, metres along z; far behind where nothing
  // was drawn.
  float At(const glm::vec2& position) const;
  bool Empty(const glm::vec2& position) const;

  int pixels() const { return pixels_; }
  glm::vec2 Middle(int x, int y) const;

 private:
  struct Range {
    int first, last;
  };
  Range Span(float low, float high, float origin) const;
  float& Pixel(int x, int y);

  Window window_;
  int pixels_;
  float pixel_m_;
  std::vector<float> depth_;
};

}  // namespace kaori::inspect
