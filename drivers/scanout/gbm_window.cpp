#include "drivers/scanout/gbm_window.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace kaori::scanout {
namespace {

constexpr std::uint32_t kFormat = GBM_FORMAT_XRGB8888;  // Every display controller scans it out.

// The buffer becomes known to the card's own file only for as long as the framebuffer needs to be made.
Result<std::uint32_t> AddFramebuffer(int card, gbm_bo* buffer) {
  const UniqueFd shared(gbm_bo_get_fd(buffer));
  std::array<std::uint32_t, 4> handles{};
  if (!shared.valid() || drmPrimeFDToHandle(card, shared.get(), handles.data()) != 0)
    return FailErrno("hand a picture to the graphics card");
  const std::array<std::uint32_t, 4> pitches{gbm_bo_get_stride(buffer)};
  const std::array<std::uint32_t, 4> offsets{};
  std::uint32_t id = 0;
  const int refused = drmModeAddFB2(card, gbm_bo_get_width(buffer), gbm_bo_get_height(buffer), kFormat,
                                    handles.data(), pitches.data(), offsets.data(), &id, 0);
  const int cause = errno;
  drmCloseBufferHandle(card, handles[0]);
  if (refused != 0) return Fail(static_cast<std::errc>(cause), "make a framebuffer of a picture");
  return id;
}

}  // namespace

Result<GbmDevice> GbmDevice::Open(const char* path, int shows) {
  GbmDevice opened;
  opened.file = UniqueFd(::open(path, O_RDWR | O_CLOEXEC));
  if (!opened.file.valid()) return FailErrno(fmt::format("open {}", path));
  drm_magic_t magic = 0;
  if (drmGetMagic(opened.file.get(), &magic) != 0 || drmAuthMagic(shows, magic) != 0)
    return FailErrno(fmt::format("be let draw on {}", path));
  opened.device.reset(gbm_create_device(opened.file.get()));
  if (!opened.device) return Fail(std::errc::no_such_device, fmt::format("draw on {}", path));
  return opened;
}

Result<std::unique_ptr<KmsPictures>> GbmWindow::Make(gbm_device* device, int card, int width_px,
                                                     int height_px) {
  std::unique_ptr<gbm_surface, GbmFree> surface(
      gbm_surface_create(device, std::uint32_t(width_px), std::uint32_t(height_px), kFormat,
                         GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING));
  if (!surface)
    return Fail(std::errc::not_enough_memory,
                fmt::format("make a window of {} x {} pixels", width_px, height_px));
  return std::make_unique<GbmWindow>(std::move(surface), card);
}

Result<std::uint32_t> GbmWindow::FramebufferOf(gbm_bo* buffer) {
  const auto known = std::ranges::find(pictures_, buffer, &Picture::buffer);
  if (known != pictures_.end()) return known->framebuffer;
  const auto made = AddFramebuffer(card_, buffer);
  if (made) pictures_.push_back({buffer, *made});
  return made;
}

Result<std::uint32_t> GbmWindow::LockFront() {
  gbm_bo* const buffer = gbm_surface_lock_front_buffer(surface_.get());
  if (buffer == nullptr) return Fail(std::errc::io_error, "take the picture that was drawn");
  ReleasePrevious();
  previous_ = std::exchange(front_, buffer);
  return FramebufferOf(buffer);
}

bool GbmWindow::Made(std::uint32_t framebuffer) const {
  return std::ranges::find(pictures_, framebuffer, &Picture::framebuffer) != pictures_.end();
}

void GbmWindow::ReleasePrevious() {
  if (previous_ != nullptr) gbm_surface_release_buffer(surface_.get(), std::exchange(previous_, nullptr));
}

}  // namespace kaori::scanout
