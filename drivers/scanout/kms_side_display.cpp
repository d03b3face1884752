#include "drivers/scanout/kms_side_display.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include "drivers/scanout/kms_settings.h"

namespace kaori::scanout {
namespace {

constexpr std::size_t kPixel_bytes = 4;
// Nobody awaits these flips, and no frame of the show has this token: a frame's has
// the process id in its upper half.
constexpr std::uint64_t kNoToken = 0;

}  // namespace

Result<std::unique_ptr<KmsSideDisplay>> KmsSideDisplay::Open(KmsDevice& card, KmsOutput output) {
  const auto& mode = output.chosen.mode;
  const auto blob = card.CreateModeBlob(mode);
  if (!blob) return tl::unexpected(blob.error());
  const auto buffer = card.CreateDumbBuffer(mode.hdisplay, mode.vdisplay);
  if (!buffer) {
    card.DestroyModeBlob(*blob);
    return tl::unexpected(buffer.error());
  }
  return std::unique_ptr<KmsSideDisplay>(new KmsSideDisplay(card, std::move(output), *buffer, *blob));
}

KmsSideDisplay::KmsSideDisplay(KmsDevice& card, KmsOutput output, KmsDumbBuffer buffer, std::uint32_t mode)
    : card_(card),
      output_(std::move(output)),
      buffer_(buffer),
      mode_(mode),
      before_(card.FramebufferOn(output_.plane)) {}

KmsSideDisplay::~KmsSideDisplay() {
  card_.UnmapDumbBuffer(buffer_);
  card_.DestroyModeBlob(mode_);
}

// The picture's rows begin at the bottom, the card's at the top. A pixel goes from R, G, B, X to the card's B,
// G, R, X, as one word: the compiler makes many at a time of it.
void KmsSideDisplay::Write(std::span<const std::uint8_t> rgbx, const ports::DisplayArea& area) {
  const auto width = static_cast<std::size_t>(width_px());
  const auto left = static_cast<std::size_t>(area.left_px);
  const auto count = static_cast<std::size_t>(area.right_px - area.left_px);
  for (int row = area.bottom_px; row < area.top_px; ++row) {
    const std::uint8_t* from = rgbx.data() + (static_cast<std::size_t>(row) * width + left) * kPixel_bytes;
    std::uint8_t* to = buffer_.bytes.data() +
                       static_cast<std::size_t>(height_px() - 1 - row) * buffer_.pitch_bytes +
                       left * kPixel_bytes;
    for (std::size_t x = 0; x < count * kPixel_bytes; x += kPixel_bytes) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, from + x, kPixel_bytes);
      pixel = (pixel & 0xFFU) << 16U | (pixel & 0xFF00U) | (pixel >> 16U & 0xFFU);
      std::memcpy(to + x, &pixel, kPixel_bytes);
    }
  }
}

Result<void> KmsSideDisplay::Show(std::span<const std::uint8_t> rgbx,
                                  std::span<const ports::DisplayArea> areas) {
  // The caller's picture may be made for an earlier screen.
  const auto whole =
      static_cast<std::size_t>(width_px()) * static_cast<std::size_t>(height_px()) * kPixel_bytes;
  const auto is_within = [this](const ports::DisplayArea& area) {
    return ports::IsWithin(area, width_px(), height_px());
  };
  if (rgbx.size() != whole || !std::ranges::all_of(areas, is_within))
    return FailInput("show a picture of another size beside the show");
  for (const ports::DisplayArea& area : areas) Write(rgbx, area);
  settings_.clear();
  if (shown_)  // The same framebuffer again, so that cards which keep a copy read it anew.
    settings_.push_back({output_.plane, DRM_MODE_OBJECT_PLANE, "FB_ID", buffer_.framebuffer});
  else
    AddOutputSettings(output_, mode_, {buffer_.framebuffer}, settings_);
  if (auto shown = card_.Commit(settings_, kNoToken, !shown_); !shown) return shown;
  // The card accepts a second commit only once the first one is presented.
  if (shown_ && before_ != 0) card_.RemoveFramebuffer(std::exchange(before_, 0));
  if (!std::exchange(shown_, true)) output_.link_is_bad = false;
  return {};
}

}  // namespace kaori::scanout
