#include "appliance/programs/monitor/cells.h"

#include <algorithm>
#include <vector>

#include "appliance/programs/monitor/palette.h"
#include "render/image/break_line.h"
#include "render/image/utf8.h"

namespace kaori::monitor {
namespace {

// Of a letter of DejaVu Sans, in hundredths of its size: a little more than the mean of a sentence.
constexpr int kLetterWidth = 60;

}  // namespace

int Pen::WidthOf(std::string_view text, int size_px) const {
  int letters = 0;
  for (; !text.empty(); ++letters) text.remove_prefix(image::FirstLetter(text).bytes);
  return letters * size_px * kLetterWidth / 100;
}

void AddLines(const std::string& text, const Pen& pen, Box box, int size_px, const image::Colour& colour,
              Cell& cell) {
  const int pitch = size_px * 13 / 10;
  std::vector<std::string> lines;
  image::BreakLine(
      text, [&](std::string_view piece) { return pen.WidthOf(piece, size_px) <= box.width; }, lines);
  const auto room = static_cast<std::size_t>(std::max(1, box.height / pitch));
  for (std::size_t i = 0; i < std::min(room, lines.size()); ++i) {
    const bool is_cut = i + 1 == room && lines.size() > room;
    cell.pieces.push_back({CutTop(box, pitch), colour, is_cut ? lines[i] + " \u2026" : lines[i], size_px});
  }
}

Cell LabelCell(const char* label, const Tag& tag, const Pen& pen, const Box& box) {
  Cell cell{box, kPanel, {}};
  Box line = box;
  CutLeft(line, pen.unit / 2);
  CutRight(line, pen.unit / 2);
  cell.pieces.push_back({line, kQuiet, label, pen.normal()});
  if (!tag.words.empty())
    cell.pieces.push_back({line, tag.colour, tag.words, pen.large(), Side::kRight});
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
