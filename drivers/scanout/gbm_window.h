// Buffers that EGL draws into and a KMS plane can show: a gbm_surface, and its pictures as framebuffers of
// the card.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <gbm.h>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "drivers/scanout/kms_device.h"

namespace kaori::scanout {

struct GbmFree {
  void operator()(gbm_device* device) const { gbm_device_destroy(device); }
  void operator()(gbm_surface* surface) const { gbm_surface_destroy(surface); }
};

// Where EGL draws: the card opened a second time. Its buffers end with the program, while the framebuffers
// made of them live in the card's held file and keep the last picture.
struct GbmDevice {
  UniqueFd file;
  std::unique_ptr<gbm_device, GbmFree> device;

  // `shows` is the card's file that shows the pictures, and vouches for this one. Errors: those of open(2);
  // permission_denied (`shows` is not the card's master); no_such_device (no driver for this card).
  static Result<GbmDevice> Open(const char* path, int shows);
};

// One thread. `device` and the card's file must outlive it; the framebuffers it made outlive it.
class GbmWindow final : public KmsPictures {
 public:
  // Errors: not_enough_memory.
  static Result<std::unique_ptr<KmsPictures>> Make(gbm_device* device, int card, int width_px, int height_px);

  GbmWindow(std::unique_ptr<gbm_surface, GbmFree> surface, int card)
      : surface_(std::move(surface)), card_(card) {}

  void* window() const override { return surface_.get(); }
  Result<std::uint32_t> LockFront() override;
  void ReleasePrevious() override;
  bool Made(std::uint32_t framebuffer) const override;

 private:
  struct Picture {
    gbm_bo* buffer;
    std::uint32_t framebuffer;
  };
  Result<std::uint32_t> FramebufferOf(gbm_bo* buffer);

  std::unique_ptr<gbm_surface, GbmFree> surface_;
  int card_;
  std::vector<Picture> pictures_;  // Those that ever came by: a handful.
  gbm_bo* front_ = nullptr;
  gbm_bo* previous_ = nullptr;
};

}  // namespace kaori::scanout
