#include "appliance/programs/monitor/page.h"

#include <algorithm>
#include <string_view>

#include "appliance/programs/monitor/palette.h"
#include "appliance/programs/monitor/parts.h"

namespace kaori::monitor {
namespace {

constexpr int kLines = 36;    // Of text that matters, one below the other on the whole screen,
constexpr int kLetters = 52;  // or units of its size beside each other.

// Time of day, act, and the marks of what is unusual.
void AddHead(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells) {
  const int u = pen.unit;
  const bool is_known = !view.time_of_day.empty();
  Box clock = CutLeft(box, u * 10);
  cells.push_back(
      {clock, kNight, {{clock, is_known ? kText : kQuiet, is_known ? view.time_of_day : "--:--:--", u * 2}}});
  Cell act{CutLeft(box, box.width / 2), kNight, {}};
  Box line = act.box;
  const int time_width = view.act_time.empty() ? 0 : u * 6;
  const Box words =
      CutLeft(line, std::min(line.width - time_width, pen.WidthOf(view.act, pen.large()) + u / 2));
  if (!view.act.empty()) act.pieces.push_back({words, kQuiet, view.act, pen.large()});
  if (!view.act_time.empty()) act.pieces.push_back({line, kText, view.act_time, pen.large()});
  cells.push_back(std::move(act));
  Cell marks{box, kNight, {}};
  for (const Tag& mark : view.marks) AddBadge(mark, pen, box, marks);
  cells.push_back(std::move(marks));
}

// What is wrong, and how fast the show is drawn.
void AddFoot(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells) {
  const int u = pen.unit;
  const Box rate = CutRight(box, u * 11);
  Cell fault{box, kPanel, {}};
  const Box mark = CutLeft(box, u / 2);
  CutLeft(box, u / 2);
  fault.pieces.push_back({mark, view.fault.colour});
  fault.pieces.push_back(
      {box, view.fault.colour == kGreen ? kQuiet : view.fault.colour, view.fault.words, pen.normal()});
  cells.push_back(std::move(fault));
  Box words = rate;
  CutRight(words, u / 2);
  cells.push_back({rate, kPanel, {{words, kQuiet, view.rate, pen.normal(), Side::kRight}}});
}

}  // namespace

int UnitOf(int width_px, int height_px) {
  return std::max(1, std::min(height_px / kLines, width_px / kLetters));
}

// The head line, the programme beside the cues, then lips, what is on, and levels; the foot line.
Page LayOut(const View& view, int width_px, int height_px) {
  const Pen pen{UnitOf(width_px, height_px)};
  const int gap = pen.unit * 4 / 5;
  Page page;
  Box rest = Inset({0, 0, width_px, height_px}, gap);
  AddHead(view, pen, CutTop(rest, pen.unit * 12 / 5), page.cells);
  CutTop(rest, gap / 2);
  AddFoot(view, pen, CutBottom(rest, pen.unit * 9 / 5), page.cells);
  CutBottom(rest, gap);
  const int programme_width = rest.width * 46 / 100;
  const int upper_height = std::max(programme_width * 9 / 16, pen.unit * 15);
  Box upper = CutTop(rest, std::min(upper_height, rest.height * 2 / 3));
  CutTop(rest, gap);
  page.programme = CutLeft(upper, programme_width);
  CutLeft(upper, gap);
  AddCues(view, pen, upper, page.cells);
  const int lips_width = std::min(rest.width / 4, rest.height * 5 / 4);
  page.lip_picture = AddLips(view, pen, CutLeft(rest, lips_width), page.cells);
  CutLeft(rest, gap);
  AddPlaying(view, pen, CutLeft(rest, rest.width * 31 / 100), page.cells);
  CutLeft(rest, gap);
  AddLevels(view, pen, rest, page.cells);
  return page;
}

}  // namespace kaori::monitor
