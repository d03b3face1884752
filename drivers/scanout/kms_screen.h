// The screens of a graphics card as one: atomic KMS shows what EGL draws, all of it on all of them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"
#include "drivers/scanout/kms_device.h"
#include "drivers/scanout/kms_side_display.h"
#include "drivers/scanout/kms_wall.h"

namespace kaori::scanout {

// Makes the buffers that EGL draws pictures of this size into: GbmSurface::Make, or a test's.
using MakeSurface = std::function<Result<std::unique_ptr<KmsSurface>>(int width_px, int height_px)>;

// Never blanks: the picture stays when this object, or its program, ends.
//
// The part of the picture of a screen that is pulled is kept for it, and
// the others play on. The screen shows again within 0.5 s after it is back.
// All calls say no_such_device, and this object is to be opened anew, once
//   - all screens are pulled,
//   - another one is plugged in,
//   - one is back with another mode, or
//   - the card delivers no flip for 2 s.
// Where the card refuses a screen's mode, Present fails and the refusal is noted in the preferences: the
// object that is opened next has another mode there, or goes without that screen.
class KmsScreen final : public ports::Scanout {
 public:
  // All screens that are plugged in, as `preferences` say. `card`, `clock` and `preferences` must outlive it.
  // Probes screens, which takes tens of milliseconds each. Errors: those of FindOutputs and of `make`.
  static Result<std::unique_ptr<KmsScreen>> Open(KmsDevice& card, const MakeSurface& make, const Clock& clock,
                                                 KmsPreferences& preferences);
  ~KmsScreen() override;

  // The screens and where their parts of the picture lie; does not change while this object lives.
  const KmsWall& wall() const { return wall_; }

  int pollable() const override { return card_.pollable(); }
  // Its target is an EglSurface.
  Result<ports::PixelBuffer> Acquire() override;
  // Presents the picture that EGL swapped last.
  Result<void> Present(std::uint64_t frame) override;
  // A frame counts as presented once every screen shows it; the time is that of the first screen.
  Result<ports::Flip> ReadFlip() override;
  ports::SideDisplay* status_display() override { return status_display_.get(); }
  ports::SideDisplay* monitor_display() override { return monitor_display_.get(); }
  std::vector<ports::Output> outputs() const override;

 private:
  // kNew: shows from the next frame on.
  enum class PanelState { kUnplugged, kNew, kShown };
  // A screen, and what is known of it since the last check.
  struct Panel {
    KmsPanel at;
    // What is known since the last check.
    PanelState state = PanelState::kNew;
    bool flip_pending = false;
    std::uint32_t mode = 0;  // The mode's blob; 0 before the first picture.
    // When a link that had failed was set up last.
    std::optional<Time> linked_at{};
  };
  KmsScreen(KmsDevice& card, KmsWall wall, std::unique_ptr<KmsSurface> surface, const Clock& clock,
            KmsPreferences& preferences);
  // Looks for screens that came, went or changed. Errors: no_such_device (this object is to be opened anew).
  Result<void> CheckConnectors();
  // Probes every connector after a hotplug report: tens of milliseconds each, which cost a
  // frame or two. Errors: as CheckConnectors.
  Result<void> ProbeAll();
  // Notes the error that every call says from now on.
  tl::unexpected<Error> Gone(const Error& error);
  // Whether a connector's screen would get a mode of the size that its panel has.
  bool IsAsBefore(const KmsConnector& connector, const Panel& panel) const;
  // Notes whether the panel's screen is plugged in. Errors: as CheckConnectors.
  Result<void> CheckPanel(Panel& panel);
  // Has a display beside the show set up anew whose link failed.
  void CheckLink(KmsSideDisplay& display);
  // Whether the connector is no panel's, and was empty before.
  bool IsNew(std::uint32_t connector) const;
  // Shows the framebuffer on every screen that is plugged in. Errors: what the card says.
  Result<void> Commit(std::uint32_t framebuffer, Time now);
  // The error that Present gives, after the screen at fault was found and its refusal noted.
  Error Blame(const Error& error, std::uint32_t framebuffer, Time now);
  // A test commit for this panel alone.
  bool CouldShow(Panel& panel, std::uint32_t framebuffer);
  // Whether the panel shows nothing of ours: it is new, or its link failed, and was not set up a moment ago.
  bool IsToBeSetUp(const Panel& panel, Time now) const;
  // Adds all settings of a panel that shows nothing of ours yet. Errors: those of CreateModeBlob.
  Result<void> AddPanel(Panel& panel, std::uint32_t framebuffer);
  // Settings that free what no panel uses.
  void AddOthersOff();
  // Notes a flip of the frame that was presented last.
  void HandleFlip(const KmsFlip& flip);
  // The first panel whose screen is plugged in: its flips are the frame's. Null: there is none.
  Panel* First();
  // Whether a screen that is plugged in has not shown the frame yet.
  bool FlipIsPending() const;
  // Removes what earlier programs left on the card's file.
  void RemoveOldFramebuffers();

  KmsDevice& card_;
  KmsWall wall_;
  std::unique_ptr<KmsSurface> surface_;
  const Clock& clock_;
  KmsPreferences& preferences_;
  std::unique_ptr<KmsSideDisplay> status_display_, monitor_display_;
  std::vector<Panel> panels_;
  // Connectors with a screen that the card cannot drive beside the others. They
  // are no news until they are pulled.
  std::vector<std::uint32_t> undriven_;
  std::vector<KmsSetting> settings_;  // Of a commit; kept, so that no frame allocates.
  Time checked_at_{};                 // When connectors were checked last.
  // When a display beside the show was set up anew last, since its link had failed.
  std::optional<Time> side_linked_at_{};
  // When Present succeeded last: a flip that takes too long is counted from here.
  Time presented_at_{};
  std::uint64_t frame_ = 0;    // The one presented last.
  std::optional<Time> shown_;  // When it was presented; until ReadFlip returns it.
  // Acquire was called since the last Present.
  bool acquired_ = false;
  bool others_removed_ = false;  // No framebuffer of another program is left.
  std::optional<Error> gone_;    // What every call says once the screen is gone.
};

}  // namespace kaori::scanout
