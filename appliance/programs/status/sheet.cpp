#include "appliance/programs/status/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "render/image/break_line.h"
#include "render/image/fill.h"

namespace kaori::status {
namespace {

using image::Colour;
using image::Fill;

// A smaller picture has no room for a letter; the sums below want a height above 0.
constexpr int kLeast_px = 16;
// A title, a show, eight devices, some of them in two rows, screens and faults; more of them, which are said in two
// languages; and the list of a stick besides.
constexpr std::array kRows{22, 26, 30};
constexpr int kLeastPitch_px = 16;  // Of smaller letters than the first: in less, kanji cannot be told apart.
constexpr int kLetters = 66;        // That fit beside each other, or the letters are made smaller.
constexpr int kNameLetters = 11;    // Of them for what a line is about.
constexpr int kNameWidth = 60;      // Of a letter there, in hundredths of its size,
constexpr int kWordWidth = 54;      // and in a sentence: a little more than the mean.
constexpr Colour kGround{16, 18, 22}, kName{150, 158, 170}, kWords{235, 238, 242};
constexpr Colour kGreen{70, 190, 110}, kAmber{235, 170, 50}, kRed{240, 80, 70};

// Colours of a traffic light, besides which each line says in words what it means.
Colour ColourOf(Mark mark) {
  switch (mark) {
    case Mark::kTitle:
      return kWords;
    case Mark::kGood:
      return kGreen;
    case Mark::kMissing:
      return kAmber;
    case Mark::kFault:
      break;
  }
  return kRed;
}

// What does not fit is told by its number, in the last row.
Line LineAt(const std::vector<Line>& lines, std::size_t row, std::size_t rows) {
  if (row + 1 < rows || lines.size() <= rows)
    return row < lines.size() ? lines[row] : Line{Mark::kTitle, "", ""};
  return {Mark::kMissing, "more", fmt::format("{} rows for which there is no room", lines.size() - rows + 1)};
}

}  // namespace

Sheet::Sheet(image::Lettering lettering, int width_px, int height_px)
    : lettering_(std::move(lettering)),
      picture_(image::Picture::Blank(std::max(width_px, kLeast_px), std::max(height_px, kLeast_px))),
      layout_(LayoutOf(kRows.front())),
      stands_(layout_.rows) {
  Fill(picture_, 0, 0, picture_.width_px, picture_.height_px, kGround);
}

// The height of a row follows the smaller of two demands: so many of them one below the other, and kLetters
// beside each other (a letter is about half as wide as its row is high).
Sheet::Layout Sheet::LayoutOf(int rows) const {
  const int pitch = std::max(1, std::min(picture_.height_px / rows, picture_.width_px * 2 / kLetters));
  const int size = std::max(1, pitch * 7 / 10);
  return {pitch, size, pitch * 3 / 2 + kNameLetters * size * kNameWidth / 100,
          static_cast<std::size_t>(std::max(1, (picture_.height_px - pitch) / pitch))};
}

// Letters that are smaller than they could be become larger when that leaves a row free: lines whose number changes
// by one now and then do not make them jump each time.
Sheet::Layout Sheet::Fitting(const std::vector<Line>& lines) const {
  Layout fitting = LayoutOf(kRows.front());
  for (const int rows : kRows) {
    const Layout layout = LayoutOf(rows);
    if (rows != kRows.front() && layout.pitch_px < kLeastPitch_px) break;
    fitting = layout;
    const std::size_t spare = layout.pitch_px > layout_.pitch_px ? 1 : 0;
    if (Broken(lines, layout).size() + spare <= layout.rows) break;
  }
  return fitting;
}

// Row 0 is at the top; pictures here have their first row at the bottom.
Sheet::Rows Sheet::RowsOf(int row) const {
  const int end = picture_.height_px - layout_.pitch_px / 2 - row * layout_.pitch_px;
  return {end - layout_.pitch_px, end};
}

// Letters are counted, and not measured: that takes no time beside the show. DrawRow cuts what is too long
// all the same.
std::vector<Line> Sheet::Broken(const std::vector<Line>& lines, const Layout& layout) const {
  const int width_px = picture_.width_px - layout.pitch_px / 2 - layout.words_px;
  const auto fits = [&](std::string_view text) {
    return image::GuessWidth_px(text, layout.size_px, kWordWidth) <= width_px;
  };
  std::vector<Line> rows;
  for (const Line& line : lines) {
    std::vector<std::string> pieces;
    image::BreakLine(line.words, fits, pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      rows.push_back({line.mark, i == 0 ? line.what : std::string(), std::move(pieces[i])});
  }
  return rows;
}

// The first row whose mark changed, else the first one whose words did. Rows without a line count as blank
// ones.
std::optional<std::size_t> Sheet::Changed(const std::vector<Line>& rows) const {
  std::optional<std::size_t> changed;
  for (std::size_t row = 0; row < stands_.size(); ++row) {
    const Line line = LineAt(rows, row, stands_.size());
    if (stands_[row] == line) continue;
    if (!stands_[row] || stands_[row]->mark != line.mark) return row;
    if (!changed) changed = row;
  }
  return changed;
}

// The row counts as drawn even where its letters did not fit.
std::optional<Sheet::Rows> Sheet::DrawNext(const std::vector<Line>& lines) {
  if (const Layout fitting = Fitting(lines); fitting.pitch_px != layout_.pitch_px) {
    layout_ = fitting;
    stands_.assign(layout_.rows, std::nullopt);
    Fill(picture_, 0, 0, picture_.width_px, picture_.height_px, kGround);
    return Rows{0, picture_.height_px};
  }
  const std::vector<Line> rows = Broken(lines, layout_);
  const auto row = Changed(rows);
  if (!row) return std::nullopt;
  const Line line = LineAt(rows, *row, stands_.size());
  DrawRow(static_cast<int>(*row), line);
  stands_[*row] = line;
  return RowsOf(static_cast<int>(*row));
}

// A square in the mark's colour, what the line is about, and its words; too long a text is shortened with
// dots.
void Sheet::DrawRow(int row, const Line& line) {
  const int pitch_px = layout_.pitch_px, size_px = layout_.size_px, words_px = layout_.words_px;
  const Rows rows = RowsOf(row);
  const int bottom = rows.first, top = rows.end;
  Fill(picture_, 0, bottom, picture_.width_px, top, kGround);
  if (line.what.empty() && line.words.empty()) return;
  if (line.mark != Mark::kTitle && !line.what.empty())
    Fill(picture_, pitch_px / 2, bottom + pitch_px / 4, pitch_px, top - pitch_px / 4, ColourOf(line.mark));
  const Colour& colour = line.mark == Mark::kGood ? kWords : ColourOf(line.mark);
  const auto draw = [&](std::string_view text, const Colour& in, int x_px, int end_px) {
    lettering_.Draw(image::Shorten(lettering_, text, size_px, end_px - x_px), {size_px, in}, x_px, bottom,
                    picture_);
  };
  draw(line.what, line.mark == Mark::kTitle ? kWords : kName, pitch_px * 3 / 2, words_px);
  draw(line.words, colour, words_px, picture_.width_px - pitch_px / 2);
}

// Row by row until none has changed, as the status display does over time.
Result<image::Picture> DrawAll(const std::vector<Line>& lines, int width_px, int height_px) {
  auto lettering = image::Lettering::Open();
  if (!lettering) return tl::unexpected(lettering.error());
  Sheet sheet(std::move(*lettering), width_px, height_px);
  while (sheet.DrawNext(lines)) continue;
  return sheet.picture();
}

}  // namespace kaori::status
