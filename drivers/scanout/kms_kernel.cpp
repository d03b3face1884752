#include "drivers/scanout/kms_kernel.h"

#include <drm_fourcc.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace kaori::scanout {
namespace {

// Of XRGB8888.
constexpr std::uint32_t kBitsOfPixel = 32;

// The CRTCs as bits, in the card's order, that the connector can be driven by. An encoder is the step
// between a CRTC and a connector; userspace only asks it for the CRTCs that it reaches.
std::uint32_t PossibleCrtcs(int card, const drmModeConnector& connector) {
  std::uint32_t bits = 0;
  for (int i = 0; i < connector.count_encoders; ++i) {
    const DrmEncoder encoder(drmModeGetEncoder(card, connector.encoders[i]));
    if (encoder) bits |= encoder->possible_crtcs;
  }
  return bits;
}

// As the kernel names connectors in sysfs.
std::string NameOf(const drmModeConnector& connector) {
  const char* const kind = drmModeGetConnectorTypeName(connector.connector_type);
  return fmt::format("{}-{}", kind == nullptr ? "screen" : kind, connector.connector_type_id);
}

Connection ConnectionOf(drmModeConnection connection) {
  if (connection == DRM_MODE_CONNECTED) return Connection::kConnected;
  return connection == DRM_MODE_DISCONNECTED ? Connection::kDisconnected : Connection::kUnknown;
}

// The buffer's bytes, black; its framebuffer is made by the caller. Owns nothing where it fails: the
// kernel undoes the mapping's offset with the handle.
Result<KmsDumbBuffer> MapDumbBuffer(int card, std::uint32_t handle, std::uint64_t size_bytes) {
  std::uint64_t offset = 0;
  void* at = MAP_FAILED;
  if (drmModeMapDumbBuffer(card, handle, &offset) == 0)
    at = ::mmap(nullptr, size_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, card, off_t(offset));
  if (at == MAP_FAILED) return FailErrno("map a dumb buffer of the graphics card");
  std::memset(at, 0, size_bytes);
  return KmsDumbBuffer{.bytes = {static_cast<std::uint8_t*>(at), size_bytes}};
}

}  // namespace

Result<UniqueFd> OpenCardFile(const char* path) {
  // Non-blocking: ReadFlip reads until there is nothing more.
  UniqueFd card(::open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK));
  if (!card.valid()) return FailErrno(fmt::format("open {}", path));
  return card;
}

bool IsMaster(int card) {
  return drmIsMaster(card) != 0;
}

Result<void> PrepareCardFile(int card) {
  // Universal planes show the primary planes, which atomic commits need; atomic
  // implies them in newer kernels only.
  for (const auto capability : {DRM_CLIENT_CAP_UNIVERSAL_PLANES, DRM_CLIENT_CAP_ATOMIC})
    if (drmSetClientCap(card, std::uint64_t(capability), 1) != 0)
      return FailErrno("enable atomic commits on the graphics card");
  // A flip that a program asked for before it died is of no use now.
  std::array<std::byte, 1024> bytes;
  while (::read(card, bytes.data(), bytes.size()) > 0) {
  }
  return {};
}

std::vector<std::uint32_t> KmsKernel::Connectors() {
  const DrmResources all(drmModeGetResources(card_));
  if (!all) return {};
  return {all->connectors, all->connectors + all->count_connectors};
}

std::vector<std::uint32_t> KmsKernel::Crtcs() {
  const DrmResources all(drmModeGetResources(card_));
  if (!all) return {};
  return {all->crtcs, all->crtcs + all->count_crtcs};
}

std::vector<KmsPlane> KmsKernel::PrimaryPlanes() {
  std::vector<KmsPlane> found;
  const DrmPlanes planes(drmModeGetPlaneResources(card_));
  for (std::uint32_t i = 0; planes && i < planes->count_planes; ++i) {
    const DrmPlane plane(drmModeGetPlane(card_, planes->planes[i]));
    if (!plane) continue;
    // Overlay and cursor planes are left alone.
    const auto type = FindProperty(card_, {plane->plane_id, DRM_MODE_OBJECT_PLANE}, "type");
    if (type && type->value == DRM_PLANE_TYPE_PRIMARY)
      found.push_back({plane->plane_id, plane->possible_crtcs});
  }
  return found;
}

bool KmsKernel::IsActive(std::uint32_t crtc) {
  const DrmCrtc now(drmModeGetCrtc(card_, crtc));
  return now && now->mode_valid != 0;
}

Connection KmsKernel::ConnectionOf(std::uint32_t connector) {
  const DrmConnector now(drmModeGetConnectorCurrent(card_, connector));
  return now ? scanout::ConnectionOf(now->connection) : Connection::kDisconnected;
}

// Asks the screen itself for its modes, over the cable: this may take tens of milliseconds.
Result<KmsConnector> KmsKernel::Probe(std::uint32_t connector) {
  const DrmConnector now(drmModeGetConnector(card_, connector));
  if (!now) return Fail(std::errc::no_such_device, "probe a connector of the graphics card");
  KmsConnector found{
      connector, NameOf(*now), now->connection == DRM_MODE_CONNECTED, PossibleCrtcs(card_, *now), {}};
  found.modes.assign(now->modes, now->modes + now->count_modes);
  const auto link = FindProperty(card_, {connector, DRM_MODE_OBJECT_CONNECTOR}, "link-status");
  found.link_is_bad = link && link->value == DRM_MODE_LINK_STATUS_BAD;
  return found;
}

Result<std::uint32_t> KmsKernel::CreateModeBlob(const drmModeModeInfo& mode) {
  std::uint32_t blob = 0;
  if (drmModeCreatePropertyBlob(card_, &mode, sizeof(mode), &blob) != 0)
    return FailErrno("create a mode on the graphics card");
  return blob;
}

void KmsKernel::DestroyModeBlob(std::uint32_t blob) {
  drmModeDestroyPropertyBlob(card_, blob);
}

Result<DrmAtomic> KmsKernel::RequestOf(std::span<const KmsSetting> settings) {
  DrmAtomic request(drmModeAtomicAlloc());
  for (const KmsSetting& setting : settings) {
    const auto id = IdOf(setting);
    if (!id) return tl::unexpected(id.error());
    if (drmModeAtomicAddProperty(request.get(), setting.object, *id, setting.value) < 0)
      return Fail(std::errc::not_enough_memory, "build a commit for the graphics card");
  }
  return request;
}

// Changes nothing on the screen. Of its reason to refuse the kernel tells no more than an errno.
Result<void> KmsKernel::TestCommit(std::span<const KmsSetting> settings) {
  const auto request = RequestOf(settings);
  if (!request) return tl::unexpected(request.error());
  // Modes may be set in the test, whether or not this commit would need it.
  constexpr std::uint32_t kFlags = DRM_MODE_ATOMIC_TEST_ONLY | DRM_MODE_ATOMIC_ALLOW_MODESET;
  if (drmModeAtomicCommit(card_, request->get(), kFlags, nullptr) != 0)
    return FailErrno("test a commit on the graphics card");
  return {};
}

Result<void> KmsKernel::Commit(std::span<const KmsSetting> settings, std::uint64_t token,
                               bool may_set_modes) {
  const auto request = RequestOf(settings);
  if (!request) return tl::unexpected(request.error());
  const std::uint32_t flags = DRM_MODE_PAGE_FLIP_EVENT | DRM_MODE_ATOMIC_NONBLOCK |
                              (may_set_modes ? std::uint32_t{DRM_MODE_ATOMIC_ALLOW_MODESET} : 0U);
  // The kernel hands the token back with the flip; it is a number and never followed.
  auto* const carried = reinterpret_cast<void*>(token);  // NOLINT(performance-no-int-to-ptr)
  if (drmModeAtomicCommit(card_, request->get(), flags, carried) != 0)
    return FailErrno("show a picture on the screen");
  return {};
}

// A property is looked up once; its id holds for as long as the card is there.
Result<std::uint32_t> KmsKernel::IdOf(const KmsSetting& setting) {
  for (const Known& known : known_)
    if (known.object == setting.object && std::strcmp(known.property, setting.property) == 0) return known.id;
  const auto found = FindProperty(card_, {setting.object, setting.kind}, setting.property);
  if (!found) return tl::unexpected(found.error());
  known_.push_back({setting.object, setting.property, found->property});
  return found->property;
}

std::optional<KmsFlip> KmsKernel::ReadFlip() {
  while (true) {
    if (from_ == until_) {
      // EAGAIN: no event waits.
      const ssize_t length = ::read(card_, events_.data(), events_.size());
      if (length <= 0) return std::nullopt;
      from_ = 0;
      until_ = std::size_t(length);
    }
    drm_event_vblank event{};
    const std::size_t left = until_ - from_;
    // Events are copied out: the buffer need not be aligned for each.
    std::memcpy(&event, &events_[from_], std::min(left, sizeof(event)));
    if (left < sizeof(drm_event) || event.base.length < sizeof(drm_event) || event.base.length > left) {
      from_ = until_;  // Nothing that can be read.
      continue;
    }
    from_ += event.base.length;
    if (event.base.type != DRM_EVENT_FLIP_COMPLETE || event.base.length < sizeof(event)) continue;
    // CLOCK_MONOTONIC, by DRM_CAP_TIMESTAMP_MONOTONIC, which every atomic driver has.
    const Time at(std::chrono::seconds(event.tv_sec) + std::chrono::microseconds(event.tv_usec));
    return KmsFlip{event.crtc_id, event.user_data, at};
  }
}

std::vector<std::uint32_t> KmsKernel::Framebuffers() {
  const DrmResources all(drmModeGetResources(card_));
  if (!all) return {};
  return {all->fbs, all->fbs + all->count_fbs};
}

void KmsKernel::RemoveFramebuffer(std::uint32_t framebuffer) {
  drmModeRmFB(card_, framebuffer);
}

std::uint32_t KmsKernel::FramebufferOn(std::uint32_t plane) {
  const DrmPlane now(drmModeGetPlane(card_, plane));
  return now ? now->fb_id : 0;
}

// Whatever fails, nothing of it is left on the card.
Result<KmsDumbBuffer> KmsKernel::CreateDumbBuffer(int width_px, int height_px) {
  const auto width = std::uint32_t(width_px), height = std::uint32_t(height_px);
  std::uint32_t handle = 0, pitch_bytes = 0;
  std::uint64_t size_bytes = 0;
  if (drmModeCreateDumbBuffer(card_, width, height, kBitsOfPixel, 0, &handle, &pitch_bytes, &size_bytes) != 0)
    return FailErrno("create a dumb buffer on the graphics card");
  auto buffer = MapDumbBuffer(card_, handle, size_bytes);
  // The framebuffer and the mapping keep it; a handle would outlive the program.
  const std::uint32_t handles[4]{handle}, pitches[4]{pitch_bytes}, offsets[4]{};
  if (buffer && drmModeAddFB2(card_, width, height, DRM_FORMAT_XRGB8888, handles, pitches, offsets,
                              &buffer->framebuffer, 0) != 0) {
    UnmapDumbBuffer(*buffer);
    buffer = FailErrno("make a framebuffer of a dumb buffer");
  }
  drmCloseBufferHandle(card_, handle);
  if (buffer) buffer->pitch_bytes = pitch_bytes;
  return buffer;
}

void KmsKernel::UnmapDumbBuffer(const KmsDumbBuffer& buffer) {
  ::munmap(buffer.bytes.data(), buffer.bytes.size());
}

}  // namespace kaori::scanout
