// A graphics card by its KMS calls: the kernel's card, or a fake one in tests. Words are
// those of KMS (drm-kms in the kernel's documentation): a plane holds a framebuffer and
// lies on a CRTC, which drives connectors.
#pragma once

#include <xf86drmMode.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

struct gbm_surface;

namespace kaori::scanout {

// A connector of the card, and the screen that is plugged into it. A snapshot.
struct KmsConnector {
  // KMS's number of the connector, which stays the same while the card is there.
  std::uint32_t id = 0;
  std::string name;  // By kind and number, as printed beside the socket, if at all: "HDMI-A-1".
  // A screen is there, and its modes were read.
  bool plugged = false;
  std::uint32_t crtcs = 0;  // Bit n: the card's n-th CRTC can drive it.
  // As the screen's EDID lists them, the preferred one usually first; empty
  // where the EDID cannot be read.
  std::vector<drmModeModeInfo> modes;
  // The training of its link failed (DisplayPort): the screen stays black until its mode is set anew, with the property
  // link-status GOOD (drm_connector.c of the kernel).
  bool link_is_bad = false;
};

// A primary plane: it holds a CRTC's whole picture. Overlay and cursor planes are not used.
struct KmsPlane {
  std::uint32_t id = 0;
  std::uint32_t crtcs = 0;  // Bit n: it can lie on the card's n-th CRTC.
};

// A property of a connector, a CRTC or a plane, and the value that it shall have.
struct KmsSetting {
  std::uint32_t object = 0;
  std::uint32_t kind = 0;     // DRM_MODE_OBJECT_...
  const char* property = "";  // As KMS names it; a literal.
  std::uint64_t value = 0;
};

// The kernel's DRM_EVENT_FLIP_COMPLETE: a commit has reached the screen of this CRTC.
struct KmsFlip {
  std::uint32_t crtc = 0;
  std::uint64_t token = 0;  // As the commit gave it.
  Time at{};                // The vertical blank, by the kernel's stamp.
};

// A buffer that the processor writes: 8-bit B, G, R, X in memory (XRGB8888), the top row first. Every
// KMS driver has such buffers; reading from them may be slow.
struct KmsDumbBuffer {
  std::uint32_t framebuffer = 0;
  std::size_t pitch_bytes = 0;    // From row to row; may be more than width * 4.
  std::span<std::uint8_t> bytes;  // Mapped until UnmapDumbBuffer.
};

// As KMS reports a connector. kUnknown is told by connectors that cannot sense a cable, as VGA.
enum class Connection { kDisconnected, kUnknown, kConnected };

// What the screens of this folder need of a card. Objects are ids, which the card gave. One
// thread. No call but Probe takes long.
class KmsDevice {
 public:
  virtual ~KmsDevice() = default;

  // Readable when ReadFlip would give a flip.
  virtual int pollable() const = 0;

  // The card's objects in its own order; empty where the card does not answer.
  virtual std::vector<std::uint32_t> Connectors() = 0;
  // The index of a CRTC in this list is its bit in the masks of connectors and planes.
  virtual std::vector<std::uint32_t> Crtcs() = 0;
  // Planes that hold a CRTC's whole picture; a CRTC without one cannot be used.
  virtual std::vector<KmsPlane> PrimaryPlanes() = 0;

  // Whether the CRTC shows a picture now, of whatever program: after a start that of the boot splash.
  virtual bool IsActive(std::uint32_t crtc) = 0;

  // Whether the kernel reported, since the last call, that a screen came or went. Probe tells which.
  virtual bool DrainHotplug() = 0;

  // What the kernel saw last, without asking the screen. Some cards see nothing until they are probed.
  virtual Connection ConnectionOf(std::uint32_t connector) = 0;

  // Asks the screen itself by reading its EDID, which takes tens of milliseconds. Errors: no_such_device (the
  // card has no such connector).
  virtual Result<KmsConnector> Probe(std::uint32_t connector) = 0;

  // Makes the mode known to the card, as a property blob that commits refer to. To be destroyed; a mode that
  // is shown stays shown. Errors: what the card says.
  virtual Result<std::uint32_t> CreateModeBlob(const drmModeModeInfo& mode) = 0;
  // Forgets a mode; a CRTC that shows it goes on.
  virtual void DestroyModeBlob(std::uint32_t blob) = 0;

  // Applies all of `settings` at the next vertical blank, or none of them, and returns before that
  // (DRM_MODE_ATOMIC_NONBLOCK). Each CRTC that they touch flips, with `token`. `may_set_modes`: modes
  // and routes may change too, which blanks a screen for up to a second. Errors: device_or_resource_busy
  // (a flip is pending), permission_denied (the file is not the master), and what the card says:
  // invalid_argument, no_space_on_device ...
  virtual Result<void> Commit(std::span<const KmsSetting> settings, std::uint64_t token,
                              bool may_set_modes) = 0;

  // Whether the card would accept `settings`, modes included (DRM_MODE_ATOMIC_TEST_ONLY).
  // Changes nothing. Errors: what the card says.
  virtual Result<void> TestCommit(std::span<const KmsSetting> settings) = 0;

  // The next flip that happened, or none. Other events are passed over.
  virtual std::optional<KmsFlip> ReadFlip() = 0;

  // The framebuffers of the card's file, of whatever program that held the file: a
  // program that died leaves its own.
  virtual std::vector<std::uint32_t> Framebuffers() = 0;
  // A framebuffer that is shown is taken off its plane, which blanks the screen.
  virtual void RemoveFramebuffer(std::uint32_t framebuffer) = 0;

  // The framebuffer that lies on the plane now, of whatever program; 0 is none.
  virtual std::uint32_t FramebufferOn(std::uint32_t plane) = 0;

  // A black buffer with a framebuffer. Errors: what the card says.
  virtual Result<KmsDumbBuffer> CreateDumbBuffer(int width_px, int height_px) = 0;

  // Unmaps its bytes. What is shown of it stays until its framebuffer is removed.
  virtual void UnmapDumbBuffer(const KmsDumbBuffer& buffer) = 0;
};

// The buffers that EGL draws the show into, in the card's memory, all of one size.
class KmsSurface {
 public:
  // Gives the buffers back; the framebuffers stay.
  virtual ~KmsSurface() = default;

  // The native window for EGL. Valid as long as the surface.
  virtual gbm_surface* native() const = 0;

  // Locks the buffer that EGL swapped last, and returns it as a framebuffer of
  // the card. To be called once after each swap. Errors: io_error (nothing was
  // swapped), and what the card says when it accepts no more framebuffers.
  virtual Result<std::uint32_t> LockFront() = 0;

  // Gives back to EGL the buffer that was locked before the
  // last one. To be called once the screens show the last one.
  virtual void ReleasePrevious() = 0;

  // Whether the framebuffer is one that LockFront returned.
  virtual bool Owns(std::uint32_t framebuffer) const = 0;
};

}  // namespace kaori::scanout
