// The kernel's KMS, on the card's own file.
#pragma once

#include <xf86drm.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/scanout/drm_objects.h"
#include "drivers/scanout/hotplug.h"
#include "drivers/scanout/kms_device.h"

namespace kaori::scanout {

// The card's file: whoever opened it first may set modes, and what it shows lasts until its last copy is
// closed.
// Opens "/dev/dri/card0" or the like. Errors: those of open(2).
Result<UniqueFd> OpenCardFile(const char* path);

bool MayShow(int card);

// Makes the file ready, be it fresh or held over from a program that died. Errors: not_supported (no atomic
// KMS), and what the card says.
Result<void> PrepareCardFile(int card);

class KmsKernel final : public KmsDevice {
 public:
  // `card` was prepared, and must outlive this.
  explicit KmsKernel(int card, Hotplug hotplug = {}) : card_(card), hotplug_(std::move(hotplug)) {}

  int pollable() const override { return card_; }
  std::vector<std::uint32_t> Connectors() override;
  std::vector<std::uint32_t> Crtcs() override;
  std::vector<KmsPlane> PrimaryPlanes() override;
  bool IsLit(std::uint32_t crtc) override;
  bool Stirred() override { return hotplug_.Heard(); }
  Plug PlugOf(std::uint32_t connector) override;
  Result<KmsConnector> Probe(std::uint32_t connector) override;
  Result<std::uint32_t> TellMode(const drmModeModeInfo& mode) override;
  void ForgetMode(std::uint32_t blob) override;
  Result<void> Commit(std::span<const KmsSetting> settings, std::uint64_t token, bool may_set_modes) override;
  Result<void> Try(std::span<const KmsSetting> settings) override;
  std::optional<KmsFlip> ReadFlip() override;
  std::vector<std::uint32_t> Framebuffers() override;
  void Remove(std::uint32_t framebuffer) override;
  std::uint32_t PictureOn(std::uint32_t plane) override;
  Result<KmsSheet> MakeSheet(int width_px, int height_px) override;
  void ForgetSheet(const KmsSheet& sheet) override;

 private:
  struct Known {  // A property that was looked up.
    std::uint32_t object;
    const char* property;
    std::uint32_t id;
  };
  Result<DrmAtomic> RequestOf(std::span<const KmsSetting> settings);
  Result<std::uint32_t> IdOf(const KmsSetting& setting);

  int card_;
  Hotplug hotplug_;
  std::vector<Known> known_;
  std::array<std::byte, 1024> events_{};  // Read from the card and not yet passed on.
  std::size_t from_ = 0;
  std::size_t until_ = 0;
};

}  // namespace kaori::scanout
