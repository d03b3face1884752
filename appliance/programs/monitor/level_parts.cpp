// The roles and the bars of the levels.
#include <algorithm>
#include <utility>

#include "appliance/programs/monitor/palette.h"
#include "appliance/programs/monitor/parts.h"

namespace kaori::monitor {
namespace {

constexpr int kColumns = 2, kRolesInRow = 4;
constexpr int kRowUnits = 14;  // A name, a bar and an owner beside each other; else letters are smaller.

// As many as there is room for: those that nobody has go first, the last ones before the others.
std::vector<Level> Fitting(std::vector<Level> levels, std::size_t room) {
  for (auto i = levels.size(); i-- > 0 && levels.size() > room;)
    if (levels[i].owner.empty()) levels.erase(levels.begin() + static_cast<std::ptrdiff_t>(i));
  if (levels.size() > room) levels.resize(room);
  return levels;
}

// Name, bar and owner; each a cell of its own, since a bar that moves needs no letters.
void AddLevel(const Level* level, const Pen& pen, Box row, std::vector<Cell>& cells) {
  const int u = std::min(pen.unit, row.width / kRowUnits);
  const Box name = CutLeft(row, row.width * 46 / 100), owner = CutRight(row, row.width * 45 / 100);
  const Box bar = row;
  const bool has = level != nullptr && !level->owner.empty();
  Box name_line = name, owner_line = owner;
  CutLeft(name_line, u / 2);
  CutLeft(owner_line, u / 2);
  cells.push_back({name, kPanel, {}});
  if (level != nullptr) cells.back().pieces.push_back({name_line, has ? kText : kQuiet, level->name, u});
  cells.push_back(level == nullptr ? Cell{bar, kPanel, {}} : BarCell(*level, pen, bar));
  cells.push_back({owner, kPanel, {}});
  if (has) cells.back().pieces.push_back({owner_line, level->colour, level->owner, u});
}

// One line for up to four roles, and a second one for more.
void AddRoles(const std::vector<Tag>& roles, const Pen& pen, Box& box, std::vector<Cell>& cells) {
  const int u = pen.unit;
  Cell cell{CutTop(box, u * 8 / 5), kPanel, {}};
  Box line = cell.box;
  CutLeft(line, u / 2);
  const auto shown = std::min<std::size_t>(roles.size(), std::size_t{2} * kRolesInRow);
  const std::size_t in_row = shown > kRolesInRow ? kRolesInRow : std::max<std::size_t>(shown, 1);
  const int width = line.width / static_cast<int>(in_row);
  for (std::size_t i = 0; i < shown; ++i) {
    if (i == in_row) {
      cells.push_back(std::move(cell));
      cell = {CutTop(box, u * 8 / 5), kPanel, {}};
      line = cell.box;
      CutLeft(line, u / 2);
    }
    Box tag = CutLeft(line, width);
    CutRight(tag, u / 2);
    cell.pieces.push_back({tag, roles[i].colour, roles[i].words, pen.normal()});
  }
  if (shown == 0) cell.pieces.push_back({line, kQuiet, "LEVELS", pen.normal()});
  cells.push_back(std::move(cell));
}

}  // namespace

void AddLevels(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells) {
  AddRoles(view.roles, pen, box, cells);
  const int pitch = pen.unit * 13 / 10, width = box.width / kColumns;
  const auto rows = static_cast<std::size_t>(std::max(0, box.height / pitch));
  const auto levels = Fitting(view.levels, rows * kColumns);
  for (int column = 0; column < kColumns; ++column) {
    Box part = column + 1 < kColumns ? CutLeft(box, width) : box;
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t i = static_cast<std::size_t>(column) * rows + row;
      AddLevel(i < levels.size() ? &levels[i] : nullptr, pen, CutTop(part, pitch), cells);
    }
    cells.push_back({part, kPanel, {}});
  }
}

}  // namespace kaori::monitor
