#include "appliance/authoring/sculpt/aim_table.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/pchip.h"

namespace kaori::sculpt {
namespace {

// One coordinate of the table's row `row`, between its columns.
//
// The table holds few points, so that a person can write it; all lines of the grid between them are read off
// monotone curves, first along each row of the table, then up each column of the grid (a tensor product). A
// curve that never overshoots keeps lines of the mesh from crossing.
Pchip AlongRow(const AimTable& table, std::size_t row, int axis) {
  std::vector<double> values;
  for (const glm::dvec3& p : table.points[row]) values.push_back(p[axis]);
  return {table.columns, values};
}

// One coordinate of all points of the grid.
void FillAxis(const AimTable& table, int axis, std::vector<glm::dvec3>& grid) {
  std::vector<Pchip> along;
  for (std::size_t row = 0; row < table.rows.size(); ++row) along.push_back(AlongRow(table, row, axis));
  for (int column = 0; column <= kColumns; ++column) {
    std::vector<double> values;
    for (const Pchip& curve : along) values.push_back(curve.At(column));
    const Pchip up(table.rows, values);
    for (int row = 0; row <= kRows; ++row) {
      grid[static_cast<std::size_t>(row) * (kColumns + 1) + static_cast<std::size_t>(column)][axis] =
          up.At(row);
    }
  }
}

double Unit(double x) {
  return std::clamp(x, 0.0, 1.0);
}

// A point inside the head or the neck, from which the skin is seen outwards; centimetres.
//
// Rows 0 to 5 are the neck, whose axis leans backwards; 5 to 11 lead from the neck through the chin to the
// face; 11 to 26 are the face, looked at from its own height; above row 26 the axis shrinks to one point (y =
// 2.5 cm), so that the crown is seen from within like the pole of a sphere.
glm::dvec3 AxisPoint(int row, glm::dvec3 aimed) {
  if (row <= 5) return {0, aimed.y, -3.2 - 0.15 * (5 - row)};
  if (row < 8) return {0, -8 - 0.3 * (8 - row), 1 - 0.9 * (8 - row)};
  if (row < 11) return {0, -5 + 0.8 * (aimed.y + 5) * (row - 8) / 3, -1};
  if (row <= 26) return {0, aimed.y, -0.8};
  const double t = (row - 26) / 10.0;
  return {0, aimed.y * (1 - t) + 2.5 * t, -0.8};
}

// 1 in the middle of the face, 0 behind the temples, under the chin and on the crown: there the skin stands
// across z, and a projection along z would miss it.
double Frontness(GridPoint at) {
  return Unit(1 - (at.column - 6) / 7.0) * Unit((at.row - 8) / 3.0) * Unit((34 - at.row) / 8.0);
}

}  // namespace

// x, y and z are curves of their own.
std::vector<glm::dvec3> AimedGrid(const AimTable& table, const AimScale& scale) {
  std::vector<glm::dvec3> grid(static_cast<std::size_t>((kColumns + 1) * (kRows + 1)));
  for (int axis = 0; axis < 3; ++axis) FillAxis(table, axis, grid);
  for (glm::dvec3& p : grid) {
    // The eyes' level is y = 0 and stays.
    p.x *= scale.x;
    p.y *= p.y < 0 ? scale.y_below_eyes : scale.y_above_eyes;
  }
  return grid;
}

glm::dvec3 ProjectionDirection(GridPoint at, glm::dvec3 aimed) {
  const glm::dvec3 outwards = glm::normalize(aimed - AxisPoint(at.row, aimed));
  const double front = Frontness(at);
  // The blend keeps neighbouring vertices from being projected past each other where the face turns into the
  // side of the head.
  return glm::normalize(outwards * (1 - front) + glm::dvec3(0, 0, front));
}

}  // namespace kaori::sculpt
