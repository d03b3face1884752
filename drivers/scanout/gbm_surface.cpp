#include "drivers/scanout/gbm_surface.h"

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

// Every CRTC scans it out: 8 bits each of X, R, G, B in a little-endian
// word. Alpha would only be ignored.
constexpr std::uint32_t kFormat = GBM_FORMAT_XRGB8888;

// Imports the buffer into the card's own file only until the
// framebuffer is made: a handle that stayed would outlive the program.
Result<std::uint32_t> AddFramebuffer(int card, gbm_bo* buffer) {
  const UniqueFd shared(gbm_bo_get_fd(buffer));
  std::array<std::uint32_t, 4> handles{};
  if (!shared.valid() || drmPrimeFDToHandle(card, shared.get(), handles.data()) != 0)
    return FailErrno("import a picture into the graphics card");
  // One plane: XRGB has its colours side by side.
  const std::array<std::uint32_t, 4> pitches{gbm_bo_get_stride(buffer)};
  const std::array<std::uint32_t, 4> offsets{};
  std::uint32_t id = 0;
  const int refused = drmModeAddFB2(card, gbm_bo_get_width(buffer), gbm_bo_get_height(buffer), kFormat,
                                    handles.data(), pitches.data(), offsets.data(), &id, 0);
  // Kept: closing the handle may change errno.
  const int cause = errno;
  drmCloseBufferHandle(card, handles[0]);
  // The import is undone in any case: the framebuffer keeps the memory.
  if (refused != 0) return Fail(static_cast<std::errc>(cause), "make a framebuffer of a picture");
  return id;
}

}  // namespace

Result<GbmDevice> GbmDevice::Open(const char* path, int master) {
  GbmDevice opened;
  opened.file = UniqueFd(::open(path, O_RDWR | O_CLOEXEC));
  if (!opened.file.valid()) return FailErrno(fmt::format("open {}", path));
  // The magic is a number by which the master knows the other file
  // (drm-internals, legacy authentication).
  drm_magic_t magic = 0;
  if (drmGetMagic(opened.file.get(), &magic) != 0 || drmAuthMagic(master, magic) != 0)
    return FailErrno(fmt::format("authenticate {} for drawing", path));
  opened.device.reset(gbm_create_device(opened.file.get()));
  if (!opened.device)
    return Fail(std::errc::no_such_device, fmt::format("find a driver that draws on {}", path));
  return opened;
}

Result<std::unique_ptr<KmsSurface>> GbmSurface::Make(gbm_device* device, int card, int width_px,
                                                     int height_px) {
  std::unique_ptr<gbm_surface, GbmFree> surface(
      gbm_surface_create(device, std::uint32_t(width_px), std::uint32_t(height_px), kFormat,
                         GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING));
  if (!surface)
    return Fail(std::errc::not_enough_memory,
                fmt::format("make a surface of {} x {} pixels", width_px, height_px));
  return std::make_unique<GbmSurface>(std::move(surface), card);
}

Result<std::uint32_t> GbmSurface::FramebufferOf(gbm_bo* buffer) {
  // EGL goes round the same few buffers, so each becomes a framebuffer once.
  const auto known = std::ranges::find(buffers_, buffer, &Buffer::object);
  if (known != buffers_.end()) return known->framebuffer;
  auto made = AddFramebuffer(card_, buffer);
  if (made) buffers_.push_back({buffer, *made});
  return made;
}

Result<std::uint32_t> GbmSurface::LockFront() {
  gbm_bo* const buffer = gbm_surface_lock_front_buffer(surface_.get());
  // EGL swapped nothing since the last call.
  if (buffer == nullptr) return Fail(std::errc::io_error, "lock the picture that was drawn");
  // Another buffer than the one that is shown must be free for EGL, or its next swap would wait.
  ReleasePrevious();
  previous_ = std::exchange(front_, buffer);
  return FramebufferOf(buffer);
}

bool GbmSurface::Owns(std::uint32_t framebuffer) const {
  return std::ranges::find(buffers_, framebuffer, &Buffer::framebuffer) != buffers_.end();
}

void GbmSurface::ReleasePrevious() {
  if (previous_ != nullptr) gbm_surface_release_buffer(surface_.get(), std::exchange(previous_, nullptr));
}

}  // namespace kaori::scanout
