#include "drivers/scanout/kms_status_display.h"

#include <cstddef>
#include <utility>

#include "drivers/scanout/kms_settings.h"

namespace kaori::scanout {
namespace {

constexpr std::size_t kBytes = 4;      // Of a pixel.
constexpr std::uint64_t kNobodys = 0;  // The token of a flip that nobody awaits: no program's frame has it.

}  // namespace

Result<std::unique_ptr<KmsStatusDisplay>> KmsStatusDisplay::Open(KmsDevice& card, KmsOutput output) {
  const auto& mode = output.chosen.mode;
  const auto told = card.TellMode(mode);
  if (!told) return tl::unexpected(told.error());
  const auto sheet = card.MakeSheet(mode.hdisplay, mode.vdisplay);
  if (!sheet) {
    card.ForgetMode(*told);
    return tl::unexpected(sheet.error());
  }
  return std::unique_ptr<KmsStatusDisplay>(new KmsStatusDisplay(card, std::move(output), *sheet, *told));
}

KmsStatusDisplay::KmsStatusDisplay(KmsDevice& card, KmsOutput output, KmsSheet sheet, std::uint32_t mode)
    : card_(card),
      output_(std::move(output)),
      sheet_(sheet),
      mode_(mode),
      before_(card.PictureOn(output_.plane)) {}

KmsStatusDisplay::~KmsStatusDisplay() {
  card_.ForgetSheet(sheet_);
  card_.ForgetMode(mode_);
}

// The picture's rows begin at the bottom, the card's at the top.
void KmsStatusDisplay::Write(std::span<const std::uint8_t> rgbx, int row) {
  const auto width = static_cast<std::size_t>(width_px());
  const std::uint8_t* from = rgbx.data() + static_cast<std::size_t>(row) * width * kBytes;
  std::uint8_t* to =
      sheet_.bytes.data() + static_cast<std::size_t>(height_px() - 1 - row) * sheet_.pitch_bytes;
  for (std::size_t x = 0; x < width; ++x, from += kBytes, to += kBytes) {
    to[0] = from[2];
    to[1] = from[1];
    to[2] = from[0];
    to[3] = 0;
  }
}

Result<void> KmsStatusDisplay::Show(std::span<const std::uint8_t> rgbx, int first, int end) {
  const auto whole = static_cast<std::size_t>(width_px()) * static_cast<std::size_t>(height_px()) * kBytes;
  if (rgbx.size() != whole || first < 0 || first > end || end > height_px())
    return FailInput("show a picture of another size on the sign");
  for (int row = first; row < end; ++row) Write(rgbx, row);
  settings_.clear();
  if (lit_)  // The same picture again: the card looks at it anew.
    settings_.push_back({output_.plane, DRM_MODE_OBJECT_PLANE, "FB_ID", sheet_.framebuffer});
  else
    AddWhole(output_, mode_, {sheet_.framebuffer}, settings_);
  if (auto shown = card_.Commit(settings_, kNobodys, !lit_); !shown) return shown;
  // A second commit is taken only after the first one came to light.
  if (lit_ && before_ != 0) card_.Remove(std::exchange(before_, 0));
  lit_ = true;
  return {};
}

}  // namespace kaori::scanout
