#include "drivers/scanout/kms_screen.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

namespace kaori::scanout {
namespace {

struct NamedValue {
  const char* name;
  std::uint64_t value;
};

Result<void> Add(int card, drmModeAtomicReq* request, DrmObject object, std::span<const NamedValue> values) {
  for (const auto& [name, value] : values) {
    const auto found = FindProperty(card, object, name);
    if (!found) return tl::unexpected(found.error());
    if (drmModeAtomicAddProperty(request, object.id, found->property, value) < 0)
      return Fail(std::errc::not_enough_memory, "ask the graphics card for a picture");
  }
  return {};
}

// The last flip among the events that the card has for us; those of other kinds are passed over.
std::optional<drm_event_vblank> ReadEvents(int card) {
  std::array<std::byte, 1024> bytes;
  std::optional<drm_event_vblank> flip;
  const ssize_t length = ::read(card, bytes.data(), bytes.size());
  for (std::size_t at = 0; length > 0 && at + sizeof(drm_event) <= std::size_t(length);) {
    drm_event head;
    std::memcpy(&head, &bytes[at], sizeof(head));
    if (head.length < sizeof(head) || at + head.length > std::size_t(length)) break;
    if (head.type == DRM_EVENT_FLIP_COMPLETE && head.length >= sizeof(drm_event_vblank))
      std::memcpy(&flip.emplace(), &bytes[at], sizeof(drm_event_vblank));
    at += head.length;
  }
  return flip;
}

// Whose flip an event is: a dead program's comes by through the same file, and is not ours.
std::uint64_t TokenOf(std::uint64_t frame) {
  return std::uint64_t(::getpid()) << 32 | (frame & 0xffffffff);
}

}  // namespace

Result<UniqueFd> KmsCard::Open(const char* path) {
  UniqueFd card(::open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK));
  if (!card.valid()) return FailErrno(fmt::format("open {}", path));
  return card;
}

Result<void> KmsCard::Prepare(int card) {
  for (const auto capability : {DRM_CLIENT_CAP_UNIVERSAL_PLANES, DRM_CLIENT_CAP_ATOMIC})
    if (drmSetClientCap(card, std::uint64_t(capability), 1) != 0)
      return FailErrno("ask the graphics card for atomic pictures");
  // A flip that a program asked for before it died is of no use now.
  while (ReadEvents(card)) {
  }
  return {};
}

Result<std::unique_ptr<ports::Scanout>> KmsScreen::Open(int card, gbm_device* device) {
  const auto output = FindOutput(card);
  if (!output) return tl::unexpected(output.error());
  auto window = GbmWindow::Make(device, card, output->mode.hdisplay, output->mode.vdisplay);
  if (!window) return tl::unexpected(window.error());
  const auto framebuffer = FindProperty(card, {output->plane, DRM_MODE_OBJECT_PLANE}, "FB_ID");
  if (!framebuffer) return tl::unexpected(framebuffer.error());
  return std::make_unique<KmsScreen>(card, *output, framebuffer->property, std::move(*window));
}

// The card keeps the mode for as long as it shows it.
KmsScreen::~KmsScreen() {
  if (mode_ != 0) drmModeDestroyPropertyBlob(card_, mode_);
}

Result<ports::PixelBuffer> KmsScreen::Acquire() {
  if (IsUnplugged(card_, output_.connector)) return Fail(std::errc::no_such_device, "draw for the screen");
  if (presented_) return Fail(std::errc::resource_unavailable_try_again, "draw for the screen");
  acquired_ = true;
  return ports::PixelBuffer{output_.mode.hdisplay, output_.mode.vdisplay, {}, window_.surface()};
}

Result<void> KmsScreen::Present(std::uint64_t frame) {
  if (!acquired_) return Fail(std::errc::invalid_argument, "present without a buffer");
  acquired_ = false;
  const auto framebuffer = window_.LockFront();
  if (!framebuffer) return tl::unexpected(framebuffer.error());
  if (auto shown = Commit(*framebuffer, frame); !shown) return shown;
  presented_ = frame;
  return {};
}

Result<ports::Flip> KmsScreen::ReadFlip() {
  const auto flip = ReadEvents(card_);
  if (!flip || !presented_ || flip->user_data != TokenOf(*presented_))
    return Fail(std::errc::resource_unavailable_try_again, "read a flip of the screen");
  if (!std::exchange(lit_, true)) RemoveOldFramebuffers();
  window_.ReleasePrevious();
  const Time at(std::chrono::seconds(flip->tv_sec) + std::chrono::microseconds(flip->tv_usec));
  return ports::Flip{at, *std::exchange(presented_, std::nullopt), PeriodOf(output_.mode)};
}

Result<void> KmsScreen::Commit(std::uint32_t framebuffer, std::uint64_t frame) {
  const DrmAtomic request(drmModeAtomicAlloc());
  if (!request) return Fail(std::errc::not_enough_memory, "ask the graphics card for a picture");
  std::uint32_t flags = DRM_MODE_PAGE_FLIP_EVENT | DRM_MODE_ATOMIC_NONBLOCK;
  if (lit_) {
    drmModeAtomicAddProperty(request.get(), output_.plane, framebuffer_property_, framebuffer);
  } else if (auto added = AddModeset(request.get(), framebuffer); !added) {
    return added;
  } else {
    flags |= DRM_MODE_ATOMIC_ALLOW_MODESET;
  }
  // The kernel hands the token back with the flip; it is a number and never followed.
  auto* const token = reinterpret_cast<void*>(TokenOf(frame));  // NOLINT(performance-no-int-to-ptr)
  if (drmModeAtomicCommit(card_, request.get(), flags, token) != 0)
    return FailErrno("show a picture on the screen");
  return {};
}

// Where the screen shows the same mode already, as after a restart, the kernel changes the picture alone.
Result<void> KmsScreen::AddModeset(drmModeAtomicReq* request, std::uint32_t framebuffer) {
  if (mode_ == 0 && drmModeCreatePropertyBlob(card_, &output_.mode, sizeof(output_.mode), &mode_) != 0)
    return FailErrno("tell the graphics card the screen's mode");
  const std::uint64_t width_px = output_.mode.hdisplay;
  const std::uint64_t height_px = output_.mode.vdisplay;
  const std::array connector{NamedValue{"CRTC_ID", output_.crtc}};
  const std::array crtc{NamedValue{"MODE_ID", mode_}, NamedValue{"ACTIVE", 1}};
  // The source rectangle is in 1/65536 of a pixel.
  const std::array plane{NamedValue{"FB_ID", framebuffer},
                         NamedValue{"CRTC_ID", output_.crtc},
                         NamedValue{"SRC_X", 0},
                         NamedValue{"SRC_Y", 0},
                         NamedValue{"SRC_W", width_px << 16},
                         NamedValue{"SRC_H", height_px << 16},
                         NamedValue{"CRTC_X", 0},
                         NamedValue{"CRTC_Y", 0},
                         NamedValue{"CRTC_W", width_px},
                         NamedValue{"CRTC_H", height_px}};
  if (auto added = Add(card_, request, {output_.connector, DRM_MODE_OBJECT_CONNECTOR}, connector); !added)
    return added;
  if (auto added = Add(card_, request, {output_.crtc, DRM_MODE_OBJECT_CRTC}, crtc); !added) return added;
  return Add(card_, request, {output_.plane, DRM_MODE_OBJECT_PLANE}, plane);
}

// Only now: removing the picture that is shown blanks the screen.
void KmsScreen::RemoveOldFramebuffers() {
  const DrmResources resources(drmModeGetResources(card_));
  for (int i = 0; resources && i < resources->count_fbs; ++i)
    if (!window_.Made(resources->fbs[i])) drmModeRmFB(card_, resources->fbs[i]);
}

}  // namespace kaori::scanout
