#include "appliance/programs/monitor/sheet.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include "appliance/programs/monitor/palette.h"

namespace kaori::monitor {
namespace {

constexpr int kLeast_px = 16;
constexpr std::uint8_t kPaint = 128;  // Of how much a pixel is paint: from here on it is.
constexpr Colour kBlack{0, 0, 0};

}  // namespace

Sheet::Sheet(image::Lettering lettering, int width_px, int height_px)
    : lettering_(std::move(lettering)),
      picture_(image::Picture::Blank(std::max(width_px, kLeast_px), std::max(height_px, kLeast_px))) {
  Fill({0, 0, picture_.width_px, picture_.height_px}, kNight);
}

// Cells at other places are drawn anew; what lay between them stays as it is.
void Sheet::Set(Page page) {
  const bool same = std::ranges::equal(page.cells, page_.cells, {}, &Cell::box, &Cell::box);
  page_ = std::move(page);
  if (same) return;
  stands_.assign(page_.cells.size(), std::nullopt);
  next_ = 0;
}

std::optional<ports::DisplayArea> Sheet::DrawNext() {
  for (std::size_t looked = 0; looked < page_.cells.size(); ++looked) {
    const std::size_t at = (next_ + looked) % page_.cells.size();
    const Cell& cell = page_.cells[at];
    if (stands_[at] == cell) continue;
    Draw(cell);
    stands_[at] = cell;
    next_ = at + 1;
    return AreaOf(cell.box);
  }
  return std::nullopt;
}

void Sheet::Draw(const Cell& cell) {
  Fill(cell.box, cell.ground);
  for (const Piece& piece : cell.pieces) Draw(piece);
}

// Letters stand in the middle of their box's height.
void Sheet::Draw(const Piece& piece) {
  if (piece.size_px == 0) return Fill(piece.box, piece.colour);
  const std::string text = image::Shorten(lettering_, piece.text, piece.size_px, piece.box.width);
  const int spare_px =
      piece.side == Side::kLeft ? 0 : std::max(0, piece.box.width - lettering_.width_px(text, piece.size_px));
  const int x_px = piece.box.left + (piece.side == Side::kMiddle ? spare_px / 2 : spare_px);
  const int y_px =
      picture_.height_px - piece.box.bottom() + (piece.box.height - lettering_.height_px(piece.size_px)) / 2;
  lettering_.Draw(text, {.size_px = piece.size_px, .rgb = piece.colour}, x_px, y_px, picture_);
}

ports::DisplayArea Sheet::DrawProgramme(const Pixels& picture) {
  return Place(picture, page_.programme, kBlack, false);
}

ports::DisplayArea Sheet::DrawLips(const Pixels& picture) {
  return Place(picture, page_.lip_picture, kPanel, true);
}

// Nearest pixels: the picture comes in about the size that is wanted.
ports::DisplayArea Sheet::Place(const Pixels& picture, const Box& place, const Colour& ground, bool tints) {
  const Box fitted = Fitted(place, picture.width_px, picture.height_px);
  if (fitted != place) Fill(place, ground);
  columns_.resize(static_cast<std::size_t>(fitted.width));
  for (std::size_t x = 0; x < columns_.size(); ++x)
    columns_[x] = x * static_cast<std::size_t>(picture.width_px) / columns_.size() * 4;
  for (int y = 0; y < fitted.height; ++y) {
    const auto row = static_cast<std::size_t>(static_cast<long>(y) * picture.height_px / fitted.height);
    const std::uint8_t* const from =
        picture.rgbx.data() + row * static_cast<std::size_t>(picture.width_px) * 4;
    std::uint8_t* to =
        picture_.rgbx.data() + (static_cast<std::size_t>(picture_.height_px - 1 - fitted.top - y) *
                                    static_cast<std::size_t>(picture_.width_px) +
                                static_cast<std::size_t>(fitted.left)) *
                                   4;
    for (const std::size_t column : columns_) {
      std::memcpy(to, from + column, 4);
      if (tints && to[3] >= kPaint)
        for (std::size_t i = 0; i < 3; ++i) to[i] = static_cast<std::uint8_t>((to[i] + 2 * kByLips[i]) / 3);
      to += 4;
    }
  }
  return AreaOf(place);
}

ports::DisplayArea Sheet::AreaOf(const Box& box) const {
  return {box.left, picture_.height_px - box.bottom(), box.right(), picture_.height_px - box.top};
}

void Sheet::Fill(const Box& box, const Colour& colour) {
  const auto area = AreaOf(box);
  image::Fill(picture_, area.left_px, area.bottom_px, area.right_px, area.top_px, colour);
}

}  // namespace kaori::monitor
