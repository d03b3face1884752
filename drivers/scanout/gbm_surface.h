// Buffers that EGL draws into and a KMS plane can show: a gbm_surface, whose buffers become
// framebuffers of the card. Drawing and showing use two files of the same card; buffers
// pass between them as dma-bufs (PRIME).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <gbm.h>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "drivers/scanout/kms_device.h"

namespace kaori::scanout {

// gbm's objects with one owner each.
struct GbmFree {
  void operator()(gbm_device* device) const { gbm_device_destroy(device); }
  void operator()(gbm_surface* surface) const { gbm_surface_destroy(surface); }
};

// The card, opened a second time for EGL to draw with. Its buffers end with the program. The framebuffers
// that are made of them belong to the card's other file, which the fd keeper holds, and keep the last
// picture: the kernel frees a buffer only when its last framebuffer and its last handle are gone.
struct GbmDevice {
  // Closes after the device that draws with it.
  UniqueFd file;
  std::unique_ptr<gbm_device, GbmFree> device;

  // Opens `path` and has it authenticated by `master`, the card's file that shows the
  // pictures: a file that is no master may not draw on a primary node without (drmAuthMagic).
  // Blocks while Mesa loads its driver. Errors:
  //   those of open(2)
  //   permission_denied  `master` is not the card's DRM master
  //   no_such_device     Mesa has no driver for this card
  static Result<GbmDevice> Open(const char* path, int master);
};

// The buffers of one size that go round between EGL and the screens: EGL draws into one while another is
// shown. One thread. The gbm_device and the card's file must outlive it. The framebuffers that it made
// outlive it, so that the last picture stays on the screen.
class GbmSurface final : public KmsSurface {
 public:
  // A surface of this size in the format XRGB8888. Errors: not_enough_memory (gbm gives no cause).
  static Result<std::unique_ptr<KmsSurface>> Make(gbm_device* device, int card, int width_px, int height_px);

  GbmSurface(std::unique_ptr<gbm_surface, GbmFree> surface, int card)
      : surface_(std::move(surface)), card_(card) {}

  gbm_surface* native() const override { return surface_.get(); }
  // As KmsSurface says. A buffer that comes for the first time costs some system calls; afterwards none.
  Result<std::uint32_t> LockFront() override;
  void ReleasePrevious() override;
  bool Owns(std::uint32_t framebuffer) const override;

  // gbm_bo pointers are kept as names: they stay valid for as long as the surface.
 private:
  // A buffer of the surface, and the framebuffer that was made of it.
  struct Buffer {
    // gbm's buffer; it belongs to the surface.
    gbm_bo* object;
    // KMS's number of the framebuffer that was made of it.
    std::uint32_t framebuffer;
  };
  // The buffer's framebuffer, made where it is new. Errors: what the card says.
  Result<std::uint32_t> FramebufferOf(gbm_bo* buffer);

  std::unique_ptr<gbm_surface, GbmFree> surface_;
  int card_;
  std::vector<Buffer> buffers_;  // Every one that was locked so far: a handful.
  // The buffer that is presented next or shown, and the one before it; null: none.
  gbm_bo* front_ = nullptr;
  // null: none. A buffer may be drawn into again only once the screens show a newer one.
  gbm_bo* previous_ = nullptr;
};

}  // namespace kaori::scanout
