// A screen on a graphics card: atomic KMS shows what EGL draws into a GBM surface.
#pragma once

#include <memory>
#include <optional>

#include "drivers/ports/scanout.h"
#include "drivers/scanout/gbm_window.h"
#include "drivers/scanout/kms_output.h"

namespace kaori::scanout {

// The card's file: whoever opened it first may set modes, and what it shows lasts until its last copy is
// closed.
struct KmsCard {
  // Opens "/dev/dri/card0" or the like. Errors: those of open(2).
  static Result<UniqueFd> Open(const char* path);

  // Makes the file ready, be it fresh or held over from a program that died. Errors: not_supported (no atomic
  // KMS), and what the card says.
  static Result<void> Prepare(int card);
};

// Never blanks: the picture stays when this object, or its program, ends.
class KmsScreen final : public ports::Scanout {
 public:
  // The first screen that is plugged into `card`, which was prepared. `card` and `device` must outlive it.
  // Errors: those of FindOutput and GbmWindow.
  static Result<std::unique_ptr<ports::Scanout>> Open(int card, gbm_device* device);

  KmsScreen(int card, const KmsOutput& output, std::uint32_t framebuffer_property, GbmWindow window)
      : card_(card),
        output_(output),
        framebuffer_property_(framebuffer_property),
        window_(std::move(window)) {}

  ~KmsScreen() override;

  int pollable() const override { return card_; }
  // The buffer names EGL's window, and has no bytes.
  Result<ports::PixelBuffer> Acquire() override;
  // As the port says; the picture is the one that EGL swapped last.
  Result<void> Present(std::uint64_t frame) override;
  Result<ports::Flip> ReadFlip() override;

 private:
  Result<void> Commit(std::uint32_t framebuffer, std::uint64_t frame);
  Result<void> AddModeset(drmModeAtomicReq* request, std::uint32_t framebuffer);
  void RemoveOldFramebuffers();

  int card_;
  KmsOutput output_;
  std::uint32_t framebuffer_property_;
  GbmWindow window_;
  std::uint32_t mode_ = 0;  // The mode, as the card knows it; none before the first picture.
  bool acquired_ = false;
  std::optional<std::uint64_t> presented_;  // Waits for its flip.
  bool lit_ = false;                        // The mode is set, and a picture of ours was shown.
};

}  // namespace kaori::scanout
