// A screen of a graphics card as a sign: one picture in the card's memory, written row by row.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "drivers/ports/status_display.h"
#include "drivers/scanout/kms_device.h"
#include "drivers/scanout/kms_output.h"

namespace kaori::scanout {

// Has commits of its own, so that no frame of the show waits for it. Never blanks: what is written stays when
// this ends.
class KmsStatusDisplay final : public ports::StatusDisplay {
 public:
  // `card` must outlive it. Errors: what the card says.
  static Result<std::unique_ptr<KmsStatusDisplay>> Open(KmsDevice& card, KmsOutput output);
  ~KmsStatusDisplay() override;

  const KmsOutput& output() const { return output_; }
  // Whether the framebuffer is this sign's, or what an earlier program shows in its place.
  bool Needs(std::uint32_t framebuffer) const {
    return framebuffer == sheet_.framebuffer || framebuffer == before_;
  }

  int width_px() const override { return output_.chosen.mode.hdisplay; }
  int height_px() const override { return output_.chosen.mode.vdisplay; }
  bool fresh() const override { return !lit_; }
  // As the port says. A wrong count of bytes or rows is invalid_argument.
  Result<void> Show(std::span<const std::uint8_t> rgbx, int first, int end) override;

 private:
  KmsStatusDisplay(KmsDevice& card, KmsOutput output, KmsSheet sheet, std::uint32_t mode);
  void Write(std::span<const std::uint8_t> rgbx, int row);

  KmsDevice& card_;
  KmsOutput output_;
  KmsSheet sheet_;
  std::uint32_t mode_;  // As the card knows it.
  std::uint32_t before_;
  bool lit_ = false;
  std::vector<KmsSetting> settings_;
};

}  // namespace kaori::scanout
