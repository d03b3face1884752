#include "appliance/authoring/sculpt/uv_grid.h"

#include "appliance/authoring/sculpt/pchip.h"

namespace kaori::sculpt {

std::vector<glm::dvec2> UvGrid() {
  // Columns and rows of the grid, and their u and v in centimetres. Of a column in the face (0 to 11) this is
  // the x of the reference face, so that a designer can read positions off a picture of it; behind the ear it
  // is the arc round the head.
  const Pchip u({0, 3, 6, 11, 14, 17, 20, 23, 26}, {0, 1.12, 2.95, 5.6, 7.7, 10.2, 13, 16.5, 21});
  const Pchip v({0, 5, 8, 11, 15, 20, 26, 31, 36}, {-17.5, -12.6, -10.2, -7.8, -4.5, -1.75, 2.1, 7.2, 13.5});
  std::vector<glm::dvec2> grid;
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) grid.emplace_back(u.At(column), v.At(row));
  }
  return grid;
}

}  // namespace kaori::sculpt
