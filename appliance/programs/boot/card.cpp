#include "appliance/programs/boot/card.h"

#include <fcntl.h>
#include <libdrm/drm.h>
#include <libdrm/drm_mode.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <string>

#include "drivers/base/folder.h"

namespace kaori::boot {
namespace {

constexpr std::uint32_t kConnected = 1;  // drm_mode_get_connector.connection: a screen is plugged in.
constexpr std::uint32_t kBits = 32;      // A pixel, and a mask of possible CRTCs.

// True where the kernel did it. Interrupted calls are made again, as libdrm's drmIoctl does.
bool Ioctl(int fd, unsigned long request, void* argument) {
  int done = 0;
  do {
    done = ::ioctl(fd, request, argument);
  } while (done != 0 && (errno == EINTR || errno == EAGAIN));
  return done == 0;
}

// The kernel's structs of DRM carry addresses in 64 bits, whatever the machine has.
std::uint64_t AddressOf(const void* at) {
  return reinterpret_cast<std::uintptr_t>(at);
}

// Object ids of the card's CRTCs, in the order of the bits of possible_crtcs, and of its connectors.
struct Resources {
  std::vector<std::uint32_t> crtcs, connectors;
};

// Two calls: the first counts, the second fills the lists. A screen may be plugged in between them.
Resources ResourcesOf(int fd) {
  drm_mode_card_res count{};
  if (!Ioctl(fd, DRM_IOCTL_MODE_GETRESOURCES, &count)) return {};
  Resources resources{std::vector<std::uint32_t>(count.count_crtcs),
                      std::vector<std::uint32_t>(count.count_connectors)};
  drm_mode_card_res which{};
  which.count_crtcs = count.count_crtcs;
  which.count_connectors = count.count_connectors;
  which.crtc_id_ptr = AddressOf(resources.crtcs.data());
  which.connector_id_ptr = AddressOf(resources.connectors.data());
  if (!Ioctl(fd, DRM_IOCTL_MODE_GETRESOURCES, &which)) return {};
  resources.crtcs.resize(std::min(count.count_crtcs, which.count_crtcs));
  resources.connectors.resize(std::min(count.count_connectors, which.count_connectors));
  return resources;
}

// A screen: how it asks to be driven, and the ids of the encoders by which a CRTC can reach it.
struct Connected {
  drm_mode_modeinfo mode{};
  std::vector<std::uint32_t> encoders;
};

// A screen's preferred mode and its encoders; none where no screen is plugged in. The first call, which has
// no room for modes, makes the kernel probe the screen: reading its EDID takes some tens of milliseconds. A
// screen without a preferred mode gets its first.
std::optional<Connected> ConnectedAt(int fd, std::uint32_t connector) {
  drm_mode_get_connector count{};
  count.connector_id = connector;
  if (!Ioctl(fd, DRM_IOCTL_MODE_GETCONNECTOR, &count)) return std::nullopt;
  if (count.connection != kConnected || count.count_modes == 0) return std::nullopt;
  std::vector<drm_mode_modeinfo> modes(count.count_modes);
  Connected connected{.encoders = std::vector<std::uint32_t>(count.count_encoders)};
  drm_mode_get_connector which{};
  which.connector_id = connector;
  which.count_modes = count.count_modes;
  which.count_encoders = count.count_encoders;
  which.modes_ptr = AddressOf(modes.data());
  which.encoders_ptr = AddressOf(connected.encoders.data());
  if (!Ioctl(fd, DRM_IOCTL_MODE_GETCONNECTOR, &which) || which.count_modes == 0) return std::nullopt;
  modes.resize(std::min<std::size_t>(modes.size(), which.count_modes));
  const auto preferred = std::ranges::find_if(
      modes, [](const auto& mode) { return (mode.type & DRM_MODE_TYPE_PREFERRED) != 0; });
  connected.mode = preferred == modes.end() ? modes.front() : *preferred;
  return connected;
}

// The CRTCs that can drive a screen, a bit for the index of each.
std::uint32_t PossibleCrtcs(int fd, const Connected& connected) {
  std::uint32_t possible = 0;
  for (const std::uint32_t id : connected.encoders) {
    drm_mode_get_encoder encoder{};
    encoder.encoder_id = id;
    if (Ioctl(fd, DRM_IOCTL_MODE_GETENCODER, &encoder)) possible |= encoder.possible_crtcs;
  }
  return possible;
}

// Makes a dumb buffer of a mode's size with the still on it, and returns its framebuffer. The kernel frees
// what a failed step leaves behind when the card is closed. 24 of the 32 bits are colour (XRGB8888). The
// mapping is undone at once: the picture lies in the buffer.
std::optional<std::uint32_t> MakeFramebuffer(int fd, const drm_mode_modeinfo& mode, const Still& still) {
  drm_mode_create_dumb made{};
  made.width = mode.hdisplay;
  made.height = mode.vdisplay;
  made.bpp = kBits;
  drm_mode_map_dumb mapped{};
  if (!Ioctl(fd, DRM_IOCTL_MODE_CREATE_DUMB, &made)) return std::nullopt;
  mapped.handle = made.handle;
  if (!Ioctl(fd, DRM_IOCTL_MODE_MAP_DUMB, &mapped)) return std::nullopt;
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
  if (!Ioctl(fd, DRM_IOCTL_MODE_ADDFB, &framebuffer)) return std::nullopt;
  return framebuffer.fb_id;
}

// Mode setting of one CRTC for one screen, as before atomic modesetting: every KMS driver still has it.
bool Show(int fd, std::uint32_t connector, const drm_mode_modeinfo& mode, const Splash& splash) {
  drm_mode_crtc set{};
  set.crtc_id = splash.crtc;
  set.fb_id = splash.framebuffer;
  set.set_connectors_ptr = AddressOf(&connector);
  set.count_connectors = 1;
  set.mode = mode;
  set.mode_valid = 1;
  return Ioctl(fd, DRM_IOCTL_MODE_SETCRTC, &set);
}

}  // namespace

Card::Card(const char* path) : fd_(::open(path, O_RDWR | O_CLOEXEC)) {}

// Each screen gets the first free CRTC that can drive it. A matching over all screens could serve one more on
// some cards; the stage does that, and a screen that stays dark for two seconds is no harm.
std::vector<Splash> Card::ShowOnAll(const Still& still) const {
  std::vector<Splash> shown;
  const Resources resources = ResourcesOf(fd_.get());
  std::uint32_t used = 0;  // A bit for each CRTC that scans out already.
  for (const std::uint32_t connector : resources.connectors) {
    const auto connected = ConnectedAt(fd_.get(), connector);
    if (!connected) continue;
    const std::uint32_t possible = PossibleCrtcs(fd_.get(), *connected) & ~used;
    const auto index = static_cast<std::size_t>(std::countr_zero(possible));
    if (index >= resources.crtcs.size()) continue;
    const auto framebuffer = MakeFramebuffer(fd_.get(), connected->mode, still);
    if (!framebuffer) continue;
    const Splash splash{resources.crtcs[index], *framebuffer};
    if (!Show(fd_.get(), connector, connected->mode, splash)) continue;
    shown.push_back(splash);
    used |= std::uint32_t{1} << index;
  }
  return shown;
}

// What the ioctl answers is not asked: a program that is no master has nothing to give up.
void Card::DropMaster() const {
  Ioctl(fd_.get(), DRM_IOCTL_DROP_MASTER, nullptr);
}

// Any one of them: a screen that the stage has not taken over yet must not go dark.
bool Card::IsShown(const std::vector<Splash>& pictures) const {
  return std::ranges::any_of(pictures, [&](const Splash& splash) {
    drm_mode_crtc now{};
    now.crtc_id = splash.crtc;
    return Ioctl(fd_.get(), DRM_IOCTL_MODE_GETCRTC, &now) && now.fb_id == splash.framebuffer;
  });
}

void GiveCards(const std::filesystem::path& folder, gid_t shows, gid_t draws) {
  constexpr uid_t kSameOwner = -1;
  constexpr mode_t kGroupsToo = 0660;
  for (const auto& file : ListFolder(folder).value_or(std::vector<std::filesystem::path>{})) {
    const std::string name = file.filename().string();
    const bool is_card = name.starts_with("card");
    if (!is_card && !name.starts_with("renderD")) continue;
    if (::chown(file.c_str(), kSameOwner, is_card ? shows : draws) == 0) ::chmod(file.c_str(), kGroupsToo);
  }
}

}  // namespace kaori::boot
