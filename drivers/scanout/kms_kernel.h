// The kernel's KMS, on the card's own file. Each call of KmsDevice is one or a few ioctls of libdrm, without
// a copy of the card's state but for the ids of properties.
#pragma once

#include <xf86drm.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/scanout/drm_objects.h"
#include "drivers/scanout/hotplug_monitor.h"
#include "drivers/scanout/kms_device.h"

namespace kaori::scanout {

// Opens "/dev/dri/card0" or the like. Whoever opens a card first is its DRM master and may set modes; what
// the file shows lasts until its last copy is closed. Errors: those of open(2).
Result<UniqueFd> OpenCardFile(const char* path);

// Whether the file is the card's DRM master: only a master may show anything.
// One file of a card is at a time.
bool IsMaster(int card);

// Enables atomic KMS on the file and drops the events that a program left in it that died. A file
// that was kept has it enabled already; twice does no harm. Errors: not_supported (the card has
// no atomic KMS), and what the card says.
Result<void> PrepareCardFile(int card);

// Not the owner of the file: KmsCard is.
class KmsKernel final : public KmsDevice {
 public:
  // `card` was prepared by PrepareCardFile and must outlive this.
  explicit KmsKernel(int card, HotplugMonitor hotplug = {}) : card_(card), hotplug_(std::move(hotplug)) {}

  int pollable() const override { return card_; }
  std::vector<std::uint32_t> Connectors() override;
  std::vector<std::uint32_t> Crtcs() override;
  std::vector<KmsPlane> PrimaryPlanes() override;
  bool IsActive(std::uint32_t crtc) override;
  bool DrainHotplug() override { return hotplug_.Drain(); }
  Connection ConnectionOf(std::uint32_t connector) override;
  Result<KmsConnector> Probe(std::uint32_t connector) override;
  Result<std::uint32_t> CreateModeBlob(const drmModeModeInfo& mode) override;
  void DestroyModeBlob(std::uint32_t blob) override;
  Result<void> Commit(std::span<const KmsSetting> settings, std::uint64_t token, bool may_set_modes) override;
  Result<void> TestCommit(std::span<const KmsSetting> settings) override;
  std::optional<KmsFlip> ReadFlip() override;
  std::vector<std::uint32_t> Framebuffers() override;
  void RemoveFramebuffer(std::uint32_t framebuffer) override;
  std::uint32_t FramebufferOn(std::uint32_t plane) override;
  Result<KmsDumbBuffer> CreateDumbBuffer(int width_px, int height_px) override;
  void UnmapDumbBuffer(const KmsDumbBuffer& buffer) override;

 private:
  // A property that was looked up. `property` is the literal of the setting,
  // which lives as long as the program.
  struct Known {
    std::uint32_t object;
    // A literal: compared by its letters.
    const char* property;
    std::uint32_t id;
  };
  // The settings as libdrm's request. Errors: not_supported (an object lacks a property), not_enough_memory.
  Result<DrmAtomic> RequestOf(std::span<const KmsSetting> settings);
  // The id of a setting's property. Errors: not_supported.
  Result<std::uint32_t> IdOf(const KmsSetting& setting);

  // The card's file, borrowed.
  int card_;
  HotplugMonitor hotplug_;
  // A few dozen at most, searched from the front: some nanoseconds each.
  std::vector<Known> known_;
  // Events read from the card; [from_, until_) is not yet passed on. A read(2) gives
  // whole events only, as many as fit.
  std::array<std::byte, 1024> events_{};
  // Where the next event begins, and where what was read ends.
  std::size_t from_ = 0;
  std::size_t until_ = 0;
};

}  // namespace kaori::scanout
