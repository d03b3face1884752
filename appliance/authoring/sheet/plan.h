// Which pictures a contact sheet is made of, before any is drawn.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "appliance/authoring/sheet/flaws.h"
#include "appliance/core/show/show.h"
#include "render/scene/scene.h"

namespace kaori::authoring {

// One picture: what is drawn, and what it is called.
struct Cell {
  // By which the page can be searched, as by label and flaws.
  std::string face;
  // The expression, the side, the style: what it is besides the face.
  std::string label;
  // As Flaws::On; empty: none. A cell with flaws is framed in red.
  std::string flaws;
  // What the studio draws.
  scene::Scene scene;
};

// Cells in rows. With `rows` or `columns` names stand at the left and above; with `columns`, none
// under the cells.
struct Section {
  // Empty: none.
  std::string heading{};
  int in_a_row = 8;
  std::vector<std::string> rows{};
  std::vector<std::string> columns{};
  std::vector<Cell> cells{};

  // Whether labels stand under the cells.
  bool has_labels() const { return columns.empty(); }
};

// One picture file.
struct Sheet {
  // Its name in the folder: "cast.png".
  std::string file;
  std::string title;
  // A line below the title.
  std::string about;
  // The line is a complaint, and red.
  bool is_flawed = false;
  // Of the cells, of what was asked for.
  float size = 1;
  std::vector<Section> sections;
};

// "1 face", "2 faces".
std::string Counted(std::size_t count, const char* what);

// For people: "11 faces, 22 expressions, 12 mouth shapes, 9 channels".
std::string CountsOf(const face::Cast& cast);

// The whole cast, its sides, its styles, the way from the first face to each other one where there is one,
// then a sheet for each face. `show` is borrowed during the call.
std::vector<Sheet> PlanSheets(const show::Show& show, const Flaws& flaws);

}  // namespace kaori::authoring
