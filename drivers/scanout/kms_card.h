// A graphics card as a program uses it: one file through which it shows, and one through which it draws. The
// first outlives the program where the service manager or the fd keeper holds a copy.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/scanout/gbm_surface.h"
#include "drivers/scanout/kms_kernel.h"
#include "drivers/scanout/kms_screen.h"

namespace kaori::scanout {

// The show's graphics card: opened once by the stage, for as long as it runs.
// Screens come and go on it. One thread.
class KmsCard {
 public:
  // Retrieves the card's file from the service manager or from the fd keeper, or opens
  // `path` ("/dev/dri/card0" or the like) anew. In the first two cases the last picture is
  // still on the screens. `fd_keeper` is a socket's path; empty where there is none. Waits
  // for the fd keeper, 5 s at most. Errors:
  //   those of open(2)
  //   not_supported   the card has no atomic KMS
  //   no_such_device  another program shows on this card, or Mesa has no driver for it
  static Result<std::unique_ptr<KmsCard>> Open(const std::string& path, const std::string& fd_keeper);

  // Gives copies of the card's file to the service manager and to the fd keeper, so that the last
  // picture stays when the program ends: both are needed, since the manager drops its copy when the
  // unit is stopped, and the keeper may be restarted itself. To be called once the first picture is
  // shown. Waits until the service manager has its copy, 5 s at most. Errors: those of
  // service::StoreFd and service::GiveToKeeper.
  Result<void> Preserve();

  // What EGL draws with. Belongs to the card.
  gbm_device* device() const { return draws_.device.get(); }

  // Counts for screens that are opened from now on. Forgets what the card refused: people
  // who ask for a mode again want it tried.
  void SetPreferences(KmsPreferences preferences) { preferences_ = std::move(preferences); }

  // All of its screens as one; errors as KmsScreen::Open, which also says how long it blocks. The card
  // and the clock must outlive it. Only one may exist at a time.
  Result<std::unique_ptr<KmsScreen>> OpenScreen(const Clock& clock);

 private:
  KmsCard(UniqueFd shows, GbmDevice draws, std::string fd_keeper)
      : shows_(std::move(shows)),
        draws_(std::move(draws)),
        fd_keeper_(std::move(fd_keeper)),
        // Hears nothing where a sandbox forbids it: then only cards work that notice by themselves.
        kernel_(shows_.get(), HotplugMonitor::Open().value_or(HotplugMonitor())) {}

  // Declared first: the kernel object and screens use it until they end.
  UniqueFd shows_;
  // Ends before the file that shows, whose master authenticated it.
  GbmDevice draws_;
  std::string fd_keeper_;
  bool kept_ = false;  // The service manager has a copy of the file.
  KmsKernel kernel_;
  KmsPreferences preferences_;
};

}  // namespace kaori::scanout
