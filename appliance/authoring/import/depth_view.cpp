#include "appliance/authoring/import/depth_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::import {
namespace {

// Half a millimetre: finer than lids are thick, and still no more than 500 x 500 cells for a head.
constexpr float kCell_m = 0.0005F;
// Three cells: on a surface that falls away steeply, the depth of a cell's middle differs by that much from
// the vertex's own.
constexpr float kBehind_m = 0.0015F;
// What lies beyond these of a figure larger than a metre falls into the outermost cells.
constexpr int kMostCells = 2000;  // A side of the picture.

// The frontmost z for each cell of a grid over x and y.
class DepthView {
 public:
  // The picture spans the given points; what is drawn beyond them falls into the cells at its edge.
  explicit DepthView(const std::vector<glm::vec3>& positions) {
    glm::vec3 most = least_ = positions.front();
    for (const glm::vec3& p : positions) {
      least_ = glm::min(least_, p);
      most = glm::max(most, p);
    }
    columns_ = std::clamp(static_cast<int>((most.x - least_.x) / kCell_m) + 1, 1, kMostCells);
    rows_ = std::clamp(static_cast<int>((most.y - least_.y) / kCell_m) + 1, 1, kMostCells);
    depth_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                  std::numeric_limits<float>::lowest());
  }

  // Rasterises a triangle of either winding: barycentric shares at each cell's middle.
  void Draw(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 least = glm::min(a, glm::min(b, c));
    const glm::vec3 most = glm::max(a, glm::max(b, c));
    const float area = Cross(b - a, c - a);
    // Seen edge-on.
    if (area == 0) return;
    for (int row = Row(least.y); row <= Row(most.y); ++row)
      for (int column = Column(least.x); column <= Column(most.x); ++column) {
        const glm::vec3 p = CellMiddle(column, row);
        const float share_b = Cross(p - a, c - a) / area;
        const float share_c = Cross(b - a, p - a) / area;
        if (share_b < 0 || share_c < 0 || share_b + share_c > 1) continue;
        Put(column, row, a.z + share_b * (b.z - a.z) + share_c * (c.z - a.z));
      }
  }

  // Only the front half of the ball can be seen.
  void Draw(const face::EyeBall& ball) {
    const float r = ball.radius_m;
    for (int row = Row(ball.centre.y - r); row <= Row(ball.centre.y + r); ++row)
      for (int column = Column(ball.centre.x - r); column <= Column(ball.centre.x + r); ++column) {
        const glm::vec3 from = CellMiddle(column, row) - ball.centre;
        // z = sqrt(r^2 - x^2 - y^2).
        const float square = r * r - from.x * from.x - from.y * from.y;
        if (square > 0) Put(column, row, ball.centre.z + std::sqrt(square));
      }
  }

  // The longest stretch of each column in which the ball lies before all that was drawn.
  std::vector<BallColumn> Seen(const face::EyeBall& ball) const {
    const float r = ball.radius_m;
    std::vector<BallColumn> seen;
    for (int column = Column(ball.centre.x - r); column <= Column(ball.centre.x + r); ++column) {
      // A run of cells that ends at row `end`; lashes or a highlight's mesh may cut an eye into several, and
      // the longest is the opening.
      int longest = 0;
      int run = 0;
      int end = 0;
      for (int row = Row(ball.centre.y - r); row <= Row(ball.centre.y + r); ++row) {
        run = IsBefore(ball, column, row) ? run + 1 : 0;
        if (run > longest) end = row + 1;
        longest = std::max(longest, run);
      }
      // The upper edge of the last cell of the run.
      const glm::vec3 corner = CellMiddle(column, end) - 0.5F * kCell_m;
      if (longest > 0)
        seen.push_back(
            {corner.x + 0.5F * kCell_m, corner.y - static_cast<float>(longest) * kCell_m, corner.y});
    }
    return seen;
  }

  // At the cell below a point.
  float At(const glm::vec3& p) const { return depth_[Cell(Column(p.x), Row(p.y))]; }

 private:
  bool IsBefore(const face::EyeBall& ball, int column, int row) const {
    const glm::vec3 from = CellMiddle(column, row) - ball.centre;
    const float square = ball.radius_m * ball.radius_m - from.x * from.x - from.y * from.y;
    return square > 0 && ball.centre.z + std::sqrt(square) > depth_[Cell(column, row)];
  }
  static float Cross(const glm::vec3& a, const glm::vec3& b) { return a.x * b.y - a.y * b.x; }
  int Column(float x) const {
    return std::clamp(static_cast<int>((x - least_.x) / kCell_m), 0, columns_ - 1);
  }
  int Row(float y) const { return std::clamp(static_cast<int>((y - least_.y) / kCell_m), 0, rows_ - 1); }
  std::size_t Cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  // In head axes; z is 0.
  glm::vec3 CellMiddle(int column, int row) const {
    return {least_.x + (static_cast<float>(column) + 0.5F) * kCell_m,
            least_.y + (static_cast<float>(row) + 0.5F) * kCell_m, 0};
  }
  void Put(int column, int row, float z) {
    float& depth = depth_[Cell(column, row)];
    depth = std::max(depth, z);
  }

  glm::vec3 least_{};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> depth_;
};

}  // namespace

// A vertex is seen where nothing in its cell lies clearly before it.
std::vector<bool> SeenFromFront(const HeadShape& head) {
  DepthView view(head.positions);
  for (const Triangle& t : head.triangles)
    // Balls hide what lies behind them, the inside of the lids above all.
    view.Draw(head.positions[t[0]], head.positions[t[1]], head.positions[t[2]]);
  for (const face::EyeBall& eye : head.eyes)
    if (eye.radius_m > 0) view.Draw(eye);
  std::vector<bool> seen;
  for (const glm::vec3& p : head.positions) seen.push_back(p.z > view.At(p) - kBehind_m);
  return seen;
}

std::vector<BallColumn> SeenOfBall(const HeadShape& head, const face::EyeBall& ball) {
  DepthView view(head.positions);
  for (const Triangle& t : head.triangles)
    view.Draw(head.positions[t[0]], head.positions[t[1]], head.positions[t[2]]);
  return view.Seen(ball);
}

}  // namespace kaori::import
