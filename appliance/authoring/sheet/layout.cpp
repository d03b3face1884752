#include "appliance/authoring/sheet/layout.h"

#include <algorithm>

namespace kaori::authoring {
namespace {

// All lengths in pixels; between cells, and around texts.
constexpr int kMargin_px = 20;
constexpr int kGap_px = 4;
constexpr int kTitle_px = 28;
constexpr int kHeading_px = 20;
// Labels are as high as a cell allows, within these: smaller cannot be read.
constexpr int kLargestLabel_px = 16;
constexpr int kSmallestLabel_px = 10;
constexpr std::array<std::uint8_t, 3> kWhite{236, 240, 248};
constexpr std::array<std::uint8_t, 3> kGrey{168, 178, 196};
constexpr std::array<std::uint8_t, 3> kRed{255, 92, 84};

// Walks down the sheet, `y_px_` being where the next thing goes. Used once.
class Arranger {
 public:
  Arranger(const Sheet& sheet, const Box& cell, image::Lettering& lettering)
      : sheet_(sheet),
        cell_(cell),
        lettering_(lettering),
        // About a dozen letters across a cell.
        label_px_(std::clamp(cell.width_px / 11, kSmallestLabel_px, kLargestLabel_px)),
        rows_width_px_(RowNamesWidth()) {}

  // The width must be known before lines are laid, the height comes of them.
  Layout Run() {
    layout_.width_px = WidestRow() + 2 * kMargin_px;
    AddLine(sheet_.title, {kTitle_px, kWhite});
    AddLine(sheet_.about, {kLargestLabel_px, sheet_.is_flawed ? kRed : kGrey});
    for (const Section& section : sheet_.sections) Add(section);
    layout_.height_px = y_px_ + kMargin_px;
    return std::move(layout_);
  }

 private:
  // The names' column at the left; 0 where no section has row names. All sections share it, so that cells
  // stand below each other.
  int RowNamesWidth() const {
    int widest_px = 0;
    for (const Section& section : sheet_.sections)
      for (const std::string& row : section.rows)
        widest_px = std::max(widest_px, lettering_.width_px(row, kLargestLabel_px));
    return widest_px == 0 ? 0 : widest_px + 2 * kGap_px;
  }

  // The title may be wider than any row. The gap behind a row's last cell does not count.
  int WidestRow() const {
    int widest_px = lettering_.width_px(sheet_.title, kTitle_px);
    for (const Section& section : sheet_.sections)
      widest_px =
          std::max(widest_px, rows_width_px_ + section.in_a_row * (cell_.width_px + kGap_px) - kGap_px);
    return widest_px;
  }

  // Cut to its box, with an ellipsis where something is missing.
  void AddLabel(const Box& box, const std::string& text, const image::TextStyle& style) {
    layout_.labels.push_back({box, image::Shorten(lettering_, text, style.size_px, box.width_px), style});
  }

  // A line across the whole sheet, below what there is.
  void AddLine(const std::string& text, const image::TextStyle& style) {
    const int height_px = lettering_.height_px(style.size_px);
    AddLabel({kMargin_px, y_px_, layout_.width_px - 2 * kMargin_px, height_px}, text, style);
    y_px_ += height_px + 2 * kGap_px;
  }

  // A section begins below what there is. Its last row may be shorter than the others.
  void Add(const Section& section) {
    if (!section.heading.empty()) {
      y_px_ += 2 * kGap_px;
      AddLine(section.heading, {kHeading_px, kWhite});
    }
    if (!section.columns.empty()) AddColumnNames(section);
    const auto in_a_row = static_cast<std::size_t>(section.in_a_row);
    for (std::size_t first = 0; first < section.cells.size(); first += in_a_row) AddRow(section, first);
  }

  // Pixels from the sheet's left edge, behind the names of the rows.
  int CellLeft(std::size_t column) const {
    return kMargin_px + rows_width_px_ + static_cast<int>(column) * (cell_.width_px + kGap_px);
  }

  void AddColumnNames(const Section& section) {
    const int height_px = lettering_.height_px(label_px_);
    for (std::size_t i = 0; i < section.columns.size(); ++i)
      AddLabel({CellLeft(i), y_px_, cell_.width_px, height_px}, section.columns[i], {label_px_, kWhite});
    y_px_ += height_px + kGap_px;
  }

  // One row of cells from number `first` on, with its name at half its height.
  void AddRow(const Section& section, std::size_t first) {
    const std::size_t row = first / static_cast<std::size_t>(section.in_a_row);
    const int name_height_px = lettering_.height_px(kLargestLabel_px);
    if (row < section.rows.size())
      AddLabel({kMargin_px, y_px_ + (cell_.height_px - name_height_px) / 2, rows_width_px_, name_height_px},
               section.rows[row], {kLargestLabel_px, kWhite});
    const int label_height_px = lettering_.height_px(label_px_);
    const std::size_t end =
        std::min(first + static_cast<std::size_t>(section.in_a_row), section.cells.size());
    for (std::size_t i = first; i < end; ++i) AddCell(section, i, i - first, label_height_px);
    y_px_ += cell_.height_px + (section.has_labels() ? label_height_px : 0) + kGap_px;
  }

  // What is wrong with it stands in the picture; what it is, below.
  void AddCell(const Section& section, std::size_t index, std::size_t column, int label_height_px) {
    const Cell& cell = section.cells[index];
    const int left = CellLeft(column);
    layout_.cells.push_back({left, y_px_, cell_.width_px, cell_.height_px});
    const int inside_px = cell_.width_px - 2 * kGap_px;
    if (section.has_labels())
      AddLabel({left, y_px_ + cell_.height_px, cell_.width_px, label_height_px}, cell.label,
               {label_px_, cell.flaws.empty() ? kWhite : kRed});
    if (!cell.flaws.empty())
      AddLabel({left + kGap_px, y_px_ + kGap_px, inside_px, label_height_px}, cell.flaws, {label_px_, kRed});
  }

  const Sheet& sheet_;
  const Box cell_;
  image::Lettering& lettering_;
  const int label_px_;
  const int rows_width_px_;
  int y_px_ = kMargin_px;
  Layout layout_;
};

}  // namespace

Layout LayOut(const Sheet& sheet, const Box& cell, image::Lettering& lettering) {
  return Arranger(sheet, cell, lettering).Run();
}

}  // namespace kaori::authoring
