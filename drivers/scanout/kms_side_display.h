// A screen of a graphics card beside those of the show: one picture in a dumb buffer, written by parts.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "drivers/ports/side_display.h"
#include "drivers/scanout/kms_device.h"
#include "drivers/scanout/kms_output.h"

namespace kaori::scanout {

// Has commits of its own, so that no frame of the show waits for it: one dumb buffer, into which changed
// areas are copied while it is shown, since a text that tears for a frame does no harm. Never blanks:
// what is shown stays when this object, or its program, ends. One thread.
class KmsSideDisplay final : public ports::SideDisplay {
 public:
  // Creates the mode and the buffer; shows nothing yet. `card` must outlive
  // it. Errors: what the card says.
  static Result<std::unique_ptr<KmsSideDisplay>> Open(KmsDevice& card, KmsOutput output);
  ~KmsSideDisplay() override;

  // What the display is driven by; does not change but for its link.
  const KmsOutput& output() const { return output_; }
  // Whether the framebuffer is this display's, or one that an earlier program left on its screen and that
  // stays until the first Show.
  bool Needs(std::uint32_t framebuffer) const {
    return framebuffer == buffer_.framebuffer || framebuffer == before_;
  }

  int width_px() const override { return output_.chosen.mode.hdisplay; }
  int height_px() const override { return output_.chosen.mode.vdisplay; }
  bool fresh() const override { return !shown_; }
  // Notes whether the training of its link failed, and has the next Show set the mode anew where it did.
  void NoteLink(bool is_bad) { output_.link_is_bad = is_bad; }
  void SetUpAnew() { shown_ = false; }
  // Errors: invalid_argument (another size, an area out of range), and what the card says. The first call
  // sets the mode; later ones show the same framebuffer again.
  Result<void> Show(std::span<const std::uint8_t> rgbx, std::span<const ports::DisplayArea> areas) override;

 private:
  KmsSideDisplay(KmsDevice& card, KmsOutput output, KmsDumbBuffer buffer, std::uint32_t mode);
  // Copies an area of the picture into the buffer, which is another way up.
  void Write(std::span<const std::uint8_t> rgbx, const ports::DisplayArea& area);

  // Borrowed; the mode and the mapping are given back to it at the end.
  KmsDevice& card_;
  KmsOutput output_;
  // Mapped for as long as this object lives.
  KmsDumbBuffer buffer_;
  std::uint32_t mode_;    // The mode's blob.
  std::uint32_t before_;  // The framebuffer that an earlier program left on the screen; 0: none, or removed.
  // The first Show succeeded, and its link works as far as is known: from then on the CRTC is ours.
  bool shown_ = false;
  // Of the commit that is made last; kept for its memory.
  std::vector<KmsSetting> settings_;
};

}  // namespace kaori::scanout
