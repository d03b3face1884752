// Which pictures a contact sheet is made of, before any is drawn.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/sheet/flaws.h"
#include "appliance/core/show/show.h"
#include "render/scene/scene.h"

namespace kaori::authoring {

struct Cell {
  std::string face;
  std::string label;  // The expression, the side, the style: what it is besides the face.
  std::string flaws;  // Empty: none.
  scene::Scene scene;
};

// Cells in rows. With `rows` or `columns` names stand at the left and above, and none under the cells.
struct Section {
  std::string heading{};
  int in_a_row = 8;
  std::vector<std::string> rows{};
  std::vector<std::string> columns{};
  std::vector<Cell> cells{};

  bool has_labels() const { return columns.empty(); }
};

struct Sheet {
  std::string file;
  std::string title;
  std::string about;       // A line below the title.
  bool is_flawed = false;  // The line is a complaint.
  float size = 1;          // Of the cells, of what was asked for.
  std::vector<Section> sections;
};

// "11 faces, 22 expressions, 12 mouth shapes, 9 channels".
std::string CountsOf(const face::Cast& cast);

std::vector<Sheet> PlanSheets(const show::Show& show, const Flaws& flaws);

}  // namespace kaori::authoring
