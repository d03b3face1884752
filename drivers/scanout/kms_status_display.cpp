#include "drivers/scanout/kms_status_display.h"

#include <cstddef>
#include <utility>

#include "drivers/scanout/kms_settings.h"

namespace kaori::scanout {
namespace {

constexpr std::size_t kPixel_bytes = 4;
// Nobody awaits these flips, and no frame of the show has this token: a frame's has
// the process id in its upper half.
constexpr std::uint64_t kNoToken = 0;

}  // namespace

Result<std::unique_ptr<KmsStatusDisplay>> KmsStatusDisplay::Open(KmsDevice& card, KmsOutput output) {
  const auto& mode = output.chosen.mode;
  const auto blob = card.CreateModeBlob(mode);
  if (!blob) return tl::unexpected(blob.error());
  const auto buffer = card.CreateDumbBuffer(mode.hdisplay, mode.vdisplay);
  if (!buffer) {
    card.DestroyModeBlob(*blob);
    return tl::unexpected(buffer.error());
  }
  return std::unique_ptr<KmsStatusDisplay>(new KmsStatusDisplay(card, std::move(output), *buffer, *blob));
}

KmsStatusDisplay::KmsStatusDisplay(KmsDevice& card, KmsOutput output, KmsDumbBuffer buffer,
                                   std::uint32_t mode)
    : card_(card),
      output_(std::move(output)),
      buffer_(buffer),
      mode_(mode),
      before_(card.FramebufferOn(output_.plane)) {}

KmsStatusDisplay::~KmsStatusDisplay() {
  card_.UnmapDumbBuffer(buffer_);
  card_.DestroyModeBlob(mode_);
}

// The picture's rows begin at the bottom, the card's at the top.
void KmsStatusDisplay::Write(std::span<const std::uint8_t> rgbx, int row) {
  const auto width = static_cast<std::size_t>(width_px());
  const std::uint8_t* from = rgbx.data() + static_cast<std::size_t>(row) * width * kPixel_bytes;
  std::uint8_t* to =
      buffer_.bytes.data() + static_cast<std::size_t>(height_px() - 1 - row) * buffer_.pitch_bytes;
  for (std::size_t x = 0; x < width; ++x, from += kPixel_bytes, to += kPixel_bytes) {
    // From R, G, B, X to the card's B, G, R, X.
    to[0] = from[2];
    to[1] = from[1];
    to[2] = from[0];
    to[3] = 0;
  }
}

Result<void> KmsStatusDisplay::Show(std::span<const std::uint8_t> rgbx, int first, int end) {
  // The caller's picture may be made for an earlier screen.
  const auto whole =
      static_cast<std::size_t>(width_px()) * static_cast<std::size_t>(height_px()) * kPixel_bytes;
  if (rgbx.size() != whole || first < 0 || first > end || end > height_px())
    return FailInput("show a picture of another size on the status display");
  for (int row = first; row < end; ++row) Write(rgbx, row);
  settings_.clear();
  if (shown_)  // The same framebuffer again, so that cards which keep a copy read it anew.
    settings_.push_back({output_.plane, DRM_MODE_OBJECT_PLANE, "FB_ID", buffer_.framebuffer});
  else
    AddOutputSettings(output_, mode_, {buffer_.framebuffer}, settings_);
  if (auto shown = card_.Commit(settings_, kNoToken, !shown_); !shown) return shown;
  // The card accepts a second commit only once the first one is presented.
  if (shown_ && before_ != 0) card_.RemoveFramebuffer(std::exchange(before_, 0));
  shown_ = true;
  return {};
}

}  // namespace kaori::scanout
