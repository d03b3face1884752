// The screens of a graphics card as one: atomic KMS shows what EGL draws, all of it on all of them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"
#include "drivers/scanout/kms_device.h"
#include "drivers/scanout/kms_status_display.h"
#include "drivers/scanout/kms_wall.h"

namespace kaori::scanout {

// Makes room for pictures of this size.
using MakePictures = std::function<Result<std::unique_ptr<KmsPictures>>(int width_px, int height_px)>;

// Never blanks: the picture stays when this object, or its program, ends.
//
// A screen that is pulled keeps its place, and the others play on. When it is back it shows again within 0.5
// s. Once all are pulled, or another one is plugged in, or one comes back with another mode, this screen is
// gone, and to be opened anew; so too where the card refuses a screen's mode, which is noted in the wishes:
// the next one is opened in another mode, or without that screen.
class KmsScreen final : public ports::Scanout {
 public:
  // All screens that are plugged in, as `wishes` say. `card`, `clock` and `wishes` must outlive it. Errors:
  // those of FindOutputs and of `make`.
  static Result<std::unique_ptr<KmsScreen>> Open(KmsDevice& card, const MakePictures& make,
                                                 const Clock& clock, KmsWishes& wishes);
  ~KmsScreen() override;

  const KmsWall& wall() const { return wall_; }

  int pollable() const override { return card_.pollable(); }
  // The buffer names EGL's window, and has no bytes.
  Result<ports::PixelBuffer> Acquire() override;
  // As the port says; the picture is the one that EGL swapped last.
  Result<void> Present(std::uint64_t frame) override;
  // Once all screens show the frame; the time is that of the first of them.
  Result<ports::Flip> ReadFlip() override;
  ports::StatusDisplay* status_display() override { return status_display_.get(); }
  std::string Words() const override;

 private:
  enum class Light { kDark, kNew, kLit };  // Pulled; to be shown from the next frame on; shown.
  struct Panel {
    KmsPanel at;
    Light light = Light::kNew;
    bool flips = false;      // It owes a flip.
    std::uint32_t mode = 0;  // As the card knows it; none before the first picture.
  };
  KmsScreen(KmsDevice& card, KmsWall wall, std::unique_ptr<KmsPictures> pictures, const Clock& clock,
            KmsWishes& wishes);
  Result<void> Look();
  Result<void> Ask();
  bool IsAsBefore(const KmsConnector& connector, const Panel& panel) const;
  Result<void> LookAt(Panel& panel);
  bool IsNewcomer(std::uint32_t connector) const;
  Result<void> Commit(std::uint32_t framebuffer);
  Error Blame(const Error& error, std::uint32_t framebuffer);
  bool CouldShow(Panel& panel, std::uint32_t framebuffer);
  Result<void> AddAll(Panel& panel, std::uint32_t framebuffer);
  void AddOthersOff();
  void HandleFlip(const KmsFlip& flip);
  Panel* First();
  bool Owes() const;
  void RemoveOldFramebuffers();

  KmsDevice& card_;
  KmsWall wall_;
  std::unique_ptr<KmsPictures> pictures_;
  const Clock& clock_;
  KmsWishes& wishes_;
  std::unique_ptr<KmsStatusDisplay> status_display_;
  std::vector<Panel> panels_;
  std::vector<std::uint32_t> seen_;   // Connectors with a screen that the card could not drive as well.
  std::vector<KmsSetting> settings_;  // Of a commit; kept, so that no frame takes from the heap.
  Time looked_{};                     // When connectors were looked at last.
  Time presented_at_{};
  std::uint64_t frame_ = 0;    // The one presented last.
  std::optional<Time> shown_;  // When it came to light; until ReadFlip told.
  bool acquired_ = false;
  bool alone_ = false;  // No framebuffer of another program is left.
};

}  // namespace kaori::scanout
