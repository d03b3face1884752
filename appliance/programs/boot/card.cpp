#include "appliance/programs/boot/card.h"

#include <fcntl.h>
#include <libdrm/drm.h>
#include <libdrm/drm_mode.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <optional>

namespace kaori::boot {
namespace {

constexpr unsigned kConnected = 1;  // What DRM says of a connector.
constexpr unsigned kBits = 32;

bool Ask(int fd, unsigned long request, void* argument) {
  int done = 0;
  do {
    done = ::ioctl(fd, request, argument);
  } while (done != 0 && (errno == EINTR || errno == EAGAIN));
  return done == 0;
}

std::uint64_t AddressOf(const void* at) {
  return reinterpret_cast<std::uintptr_t>(at);
}

struct Parts {
  std::vector<std::uint32_t> controllers, connectors;
};

// Asked twice: how many there are, then which.
Parts PartsOf(int fd) {
  drm_mode_card_res count{};
  if (!Ask(fd, DRM_IOCTL_MODE_GETRESOURCES, &count)) return {};
  Parts parts{std::vector<std::uint32_t>(count.count_crtcs),
              std::vector<std::uint32_t>(count.count_connectors)};
  drm_mode_card_res which{};
  which.count_crtcs = count.count_crtcs;
  which.count_connectors = count.count_connectors;
  which.crtc_id_ptr = AddressOf(parts.controllers.data());
  which.connector_id_ptr = AddressOf(parts.connectors.data());
  if (!Ask(fd, DRM_IOCTL_MODE_GETRESOURCES, &which)) return {};
  parts.controllers.resize(std::min(count.count_crtcs, which.count_crtcs));
  parts.connectors.resize(std::min(count.count_connectors, which.count_connectors));
  return parts;
}

struct Plugged {
  drm_mode_modeinfo mode{};
  std::vector<std::uint32_t> encoders;
};

// A screen's preferred mode, and what could drive it; none where no screen is plugged in.
std::optional<Plugged> PluggedAt(int fd, std::uint32_t connector) {
  drm_mode_get_connector count{};
  count.connector_id = connector;
  if (!Ask(fd, DRM_IOCTL_MODE_GETCONNECTOR, &count)) return std::nullopt;
  if (count.connection != kConnected || count.count_modes == 0) return std::nullopt;
  std::vector<drm_mode_modeinfo> modes(count.count_modes);
  Plugged plugged{.encoders = std::vector<std::uint32_t>(count.count_encoders)};
  drm_mode_get_connector which{};
  which.connector_id = connector;
  which.count_modes = count.count_modes;
  which.count_encoders = count.count_encoders;
  which.modes_ptr = AddressOf(modes.data());
  which.encoders_ptr = AddressOf(plugged.encoders.data());
  if (!Ask(fd, DRM_IOCTL_MODE_GETCONNECTOR, &which) || which.count_modes == 0) return std::nullopt;
  modes.resize(std::min<std::size_t>(modes.size(), which.count_modes));
  const auto preferred = std::ranges::find_if(
      modes, [](const auto& mode) { return (mode.type & DRM_MODE_TYPE_PREFERRED) != 0; });
  plugged.mode = preferred == modes.end() ? modes.front() : *preferred;
  return plugged;
}

// The controllers that can drive a screen, one bit for each.
unsigned ControllersFor(int fd, const Plugged& plugged) {
  unsigned possible = 0;
  for (const std::uint32_t id : plugged.encoders) {
    drm_mode_get_encoder encoder{};
    encoder.encoder_id = id;
    if (Ask(fd, DRM_IOCTL_MODE_GETENCODER, &encoder)) possible |= encoder.possible_crtcs;
  }
  return possible;
}

// A picture of a mode's size with the still on it: its framebuffer.
std::optional<unsigned> Paint(int fd, const drm_mode_modeinfo& mode, const Still& still) {
  drm_mode_create_dumb made{};
  made.width = mode.hdisplay;
  made.height = mode.vdisplay;
  made.bpp = kBits;
  drm_mode_map_dumb mapped{};
  if (!Ask(fd, DRM_IOCTL_MODE_CREATE_DUMB, &made)) return std::nullopt;
  mapped.handle = made.handle;
  if (!Ask(fd, DRM_IOCTL_MODE_MAP_DUMB, &mapped)) return std::nullopt;
  void* const at = ::mmap(nullptr, made.size, PROT_READ | PROT_WRITE, MAP_SHARED, fd, off_t(mapped.offset));
  if (at == MAP_FAILED) return std::nullopt;
  LayStill(still, {static_cast<std::uint8_t*>(at), mode.hdisplay, mode.vdisplay, made.pitch});
  ::munmap(at, made.size);
  drm_mode_fb_cmd framebuffer{};
  framebuffer.width = mode.hdisplay;
  framebuffer.height = mode.vdisplay;
  framebuffer.pitch = made.pitch;
  framebuffer.bpp = kBits;
  framebuffer.depth = 24;
  framebuffer.handle = made.handle;
  if (!Ask(fd, DRM_IOCTL_MODE_ADDFB, &framebuffer)) return std::nullopt;
  return framebuffer.fb_id;
}

bool Show(int fd, std::uint32_t connector, const drm_mode_modeinfo& mode, const Lit& lit) {
  drm_mode_crtc set{};
  set.crtc_id = lit.controller;
  set.fb_id = lit.framebuffer;
  set.set_connectors_ptr = AddressOf(&connector);
  set.count_connectors = 1;
  set.mode = mode;
  set.mode_valid = 1;
  return Ask(fd, DRM_IOCTL_MODE_SETCRTC, &set);
}

}  // namespace

Card::Card(const char* path) : fd_(::open(path, O_RDWR | O_CLOEXEC)) {}

Card::~Card() {
  if (fd_ >= 0) ::close(fd_);
}

std::vector<Lit> Card::Light(const Still& still) const {
  std::vector<Lit> lit;
  const Parts parts = PartsOf(fd_);
  unsigned taken = 0;
  for (const std::uint32_t connector : parts.connectors) {
    const auto plugged = PluggedAt(fd_, connector);
    if (!plugged) continue;
    const unsigned possible = ControllersFor(fd_, *plugged) & ~taken;
    for (unsigned i = 0; i < parts.controllers.size() && i < kBits; ++i) {
      if ((possible >> i & 1U) == 0) continue;
      const auto framebuffer = Paint(fd_, plugged->mode, still);
      if (!framebuffer) break;
      const Lit next{parts.controllers[i], *framebuffer};
      if (!Show(fd_, connector, plugged->mode, next)) break;
      lit.push_back(next);
      taken |= 1U << i;
      break;
    }
  }
  return lit;
}

void Card::GiveWay() const {
  Ask(fd_, DRM_IOCTL_DROP_MASTER, nullptr);
}

bool Card::Shows(const std::vector<Lit>& pictures) const {
  return std::ranges::any_of(pictures, [&](const Lit& lit) {
    drm_mode_crtc now{};
    now.crtc_id = lit.controller;
    return Ask(fd_, DRM_IOCTL_MODE_GETCRTC, &now) && now.fb_id == lit.framebuffer;
  });
}

}  // namespace kaori::boot
