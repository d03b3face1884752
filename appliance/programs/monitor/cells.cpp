#include "appliance/programs/monitor/cells.h"

#include <algorithm>
#include <vector>

#include "appliance/programs/monitor/palette.h"
#include "render/image/break_line.h"
#include "render/image/text.h"

namespace kaori::monitor {
namespace {

// Of a letter of DejaVu Sans, in hundredths of its size: a little more than the mean of a sentence.
constexpr int kLetterWidth = 60;

}  // namespace

int Pen::WidthOf(std::string_view text, int size_px) const {
  return image::GuessWidth_px(text, size_px, kLetterWidth);
}

void AddLines(const Lines& lines, const Pen& pen, Box box, Cell& cell) {
  const int pitch = std::max(1, lines.size_px * 13 / 10);
  std::vector<std::string> pieces;
  image::BreakLine(
      lines.text, [&](std::string_view piece) { return pen.WidthOf(piece, lines.size_px) <= box.width; },
      pieces);
  const auto room = static_cast<std::size_t>(std::max(1, box.height / pitch));
  const std::size_t shown = std::min(room, pieces.size());
  if (lines.in_the_middle) CutTop(box, (box.height - static_cast<int>(shown) * pitch) / 2);
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_cut = i + 1 == shown && pieces.size() > shown;
    cell.pieces.push_back(
        {CutTop(box, pitch), lines.colour, is_cut ? pieces[i] + " \u2026" : pieces[i], lines.size_px});
  }
}

void AddBadge(const Tag& tag, const Pen& pen, Box& line, Cell& cell) {
  const int height = pen.unit * 8 / 5, width = pen.WidthOf(tag.words, pen.unit * 6 / 5) + pen.unit;
  if (width > line.width) return;
  Box badge = CutRight(line, width);
  badge.top += (badge.height - height) / 2;
  badge.height = height;
  cell.pieces.push_back({badge, tag.colour});
  cell.pieces.push_back({badge, kNight, tag.words, pen.normal(), Side::kMiddle});
  CutRight(line, pen.unit / 2);
}

Cell LabelCell(const char* label, const Tag& tag, const Pen& pen, const Box& box) {
  Cell cell{box, kPanel, {}};
  Box line = box;
  CutLeft(line, pen.unit / 2);
  CutRight(line, pen.unit / 2);
  cell.pieces.push_back({line, kQuiet, label, pen.normal()});
  CutLeft(line, pen.WidthOf(label, pen.unit * 6 / 5));
  const bool fits = pen.WidthOf(tag.words, pen.large()) <= line.width;
  if (!tag.words.empty())
    cell.pieces.push_back({line, tag.colour, tag.words, fits ? pen.large() : pen.normal(), Side::kRight});
  return cell;
}

Cell BarCell(const Level& level, const Pen& pen, const Box& box) {
  Cell cell{box, kPanel, {}};
  const int thick = std::max(2, pen.unit / 2);
  const Box groove{box.left, box.top + (box.height - thick) / 2, box.width, thick};
  const auto at = [&](float share) { return static_cast<int>(share * static_cast<float>(groove.width)); };
  const int from = std::min(at(level.rest), at(level.share)), to = std::max(at(level.rest), at(level.share));
  const int line = std::max(1, pen.unit / 10);
  cell.pieces.push_back({groove, kGroove});
  cell.pieces.push_back({{groove.left + from, groove.top, std::max(line, to - from), thick}, level.colour});
  cell.pieces.push_back({{groove.left + std::min(at(level.rest), groove.width - line), groove.top - thick / 3,
                          line, thick + 2 * (thick / 3)},
                         kText});
  return cell;
}

}  // namespace kaori::monitor
