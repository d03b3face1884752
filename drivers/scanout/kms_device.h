// What a graphics card is asked and told about its screens: by the kernel's KMS, or by a test.
#pragma once

#include <xf86drmMode.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::scanout {

// A socket of the card, and what is plugged into it.
struct KmsConnector {
  std::uint32_t id = 0;
  std::string name;  // As printed beside the socket, if at all: "HDMI-A-1".
  bool plugged = false;
  std::uint32_t crtcs = 0;  // Bit n: the card's n-th CRTC can drive it.
  std::vector<drmModeModeInfo> modes;
};

// A plane that holds a CRTC's whole picture.
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

struct KmsFlip {
  std::uint32_t crtc = 0;
  std::uint64_t token = 0;  // As the commit gave it.
  Time at{};
};

// A picture that programs write into byte by byte: 8-bit B, G, R, X, the top row first. As large as was asked
// for.
struct KmsSheet {
  std::uint32_t framebuffer = 0;
  std::size_t pitch_bytes = 0;  // From row to row.
  std::span<std::uint8_t> bytes;
};

enum class Plug { kEmpty, kUnknown, kPlugged };

// One thread. No call but Probe takes long.
class KmsDevice {
 public:
  virtual ~KmsDevice() = default;

  virtual int pollable() const = 0;  // Readable when there are flips.

  // All in the card's own order; empty where the card does not answer.
  virtual std::vector<std::uint32_t> Connectors() = 0;
  virtual std::vector<std::uint32_t> Crtcs() = 0;
  virtual std::vector<KmsPlane> PrimaryPlanes() = 0;
  // Whether the CRTC shows something now, of whatever program.
  virtual bool IsLit(std::uint32_t crtc) = 0;

  // Whether the kernel said, since this was asked last, that a screen came or went: Probe tells which.
  virtual bool Stirred() = 0;
  // What the kernel has seen last; asks nothing of the cable. Some cards see nothing until they are probed.
  virtual Plug PlugOf(std::uint32_t connector) = 0;
  // Asks the screen itself, which takes tens of milliseconds. Errors: no_such_device (no such connector).
  virtual Result<KmsConnector> Probe(std::uint32_t connector) = 0;

  // The mode as the card's object, to be forgotten again; what is shown keeps it. Errors: what the card says.
  virtual Result<std::uint32_t> TellMode(const drmModeModeInfo& mode) = 0;
  virtual void ForgetMode(std::uint32_t blob) = 0;

  // All of `settings` at the next vertical blank, or none; does not wait. Each CRTC that they touch flips,
  // with the token. Errors: device_or_resource_busy (a flip is pending), and what the card says.
  virtual Result<void> Commit(std::span<const KmsSetting> settings, std::uint64_t token,
                              bool may_set_modes) = 0;

  // Whether the card would take `settings`, modes included; changes nothing. Errors: what the card says.
  virtual Result<void> Try(std::span<const KmsSetting> settings) = 0;

  // The next flip that happened; none left. Other events are passed over.
  virtual std::optional<KmsFlip> ReadFlip() = 0;

  // Those of the card's file, of whatever program.
  virtual std::vector<std::uint32_t> Framebuffers() = 0;
  virtual void Remove(std::uint32_t framebuffer) = 0;
  // The framebuffer that lies on the plane now, of whatever program; 0 is none.
  virtual std::uint32_t PictureOn(std::uint32_t plane) = 0;

  // A blank one. Errors: what the card says.
  virtual Result<KmsSheet> MakeSheet(int width_px, int height_px) = 0;
  // Its bytes are gone; what is shown of it stays until its framebuffer is removed.
  virtual void ForgetSheet(const KmsSheet& sheet) = 0;
};

// What is shown: pictures in the card's memory, all of one size.
class KmsPictures {
 public:
  virtual ~KmsPictures() = default;

  // What EGL draws into; or none.
  virtual void* window() const = 0;
  // Takes the picture that EGL swapped last, as a framebuffer of the card. To be called once after each swap.
  // Errors: io_error (nothing was swapped), and what the card says when it takes no more buffers.
  virtual Result<std::uint32_t> LockFront() = 0;
  // Gives back the picture taken before the last one: the screens have let it go.
  virtual void ReleasePrevious() = 0;
  // Whether the framebuffer is one of these.
  virtual bool Made(std::uint32_t framebuffer) const = 0;
};

}  // namespace kaori::scanout
