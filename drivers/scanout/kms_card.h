// A graphics card as a program uses it: the file through which it shows, which outlives the program where
// somebody holds it, and the one through which it draws.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/scanout/gbm_window.h"
#include "drivers/scanout/kms_kernel.h"
#include "drivers/scanout/kms_screen.h"

namespace kaori::scanout {

class KmsCard {
 public:
  // Takes the card's file back from the service manager or from `holder` (a socket, where there is one), else
  // opens "/dev/dri/card0" or the like anew. Errors: those of open(2); not_supported (no atomic KMS);
  // no_such_device (another program shows on this card, or no driver draws on it).
  static Result<std::unique_ptr<KmsCard>> Open(const std::string& path, const std::string& holder);

  // Gives the card's file to both, so that the last picture stays when the program ends. Waits until the
  // service manager has it, 5 s at most. Errors: those of service::Keep and service::GiveToKeeper.
  Result<void> Hold();

  // For EGL.
  gbm_device* device() const { return draws_.device.get(); }

  // Holds for screens that are opened from now on.
  void Wish(KmsWishes wishes) { wishes_ = std::move(wishes); }

  // All its screens as one, as KmsScreen::Open says. The card must outlive it.
  Result<std::unique_ptr<KmsScreen>> OpenScreen(const Clock& clock);

 private:
  KmsCard(UniqueFd shows, GbmDevice draws, std::string holder)
      : shows_(std::move(shows)),
        draws_(std::move(draws)),
        holder_(std::move(holder)),
        // Deaf where a sandbox forbids it: then cards are believed that notice by themselves.
        kernel_(shows_.get(), Hotplug::Open().value_or(Hotplug())) {}

  UniqueFd shows_;
  GbmDevice draws_;
  std::string holder_;
  bool kept_ = false;  // The service manager has the file.
  KmsKernel kernel_;
  KmsWishes wishes_;
};

}  // namespace kaori::scanout
