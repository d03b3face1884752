// A graphics card as the first program finds it: shows one picture on all its screens by dumb buffers and the
// kernel's oldest mode-setting calls, without any library.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "appliance/programs/boot/still.h"
#include "drivers/base/unique_fd.h"

namespace kaori::boot {

// One screen that shows the boot splash: the CRTC that scans out, and the framebuffer. Both are ids of KMS
// objects, and hold as long as the card's file is open.
struct Splash {
  std::uint32_t crtc = 0;
  std::uint32_t framebuffer = 0;
};

// One card's open file. The kernel keeps the pictures on the screens for as long as the file is open and no
// other program shows its own. One thread; every call blocks for the kernel's mode setting only.
class Card {
 public:
  // Opens `path`; where that fails every other call does nothing. The first program that opens a card is its
  // DRM master, without which no mode can be set.
  explicit Card(const char* path);

  // Shows `still` on every screen that is plugged in, in the mode that the screen prefers. A screen for which
  // any step fails stays dark. Borrows the still's bytes during the call. Returns what is shown.
  std::vector<Splash> ShowOnAll(const Still& still) const;

  // Gives up DRM master, so that the next program that opens the card becomes it. The pictures stay until
  // then.
  void DropMaster() const;

  // Whether any of the pictures is still scanned out. False as soon as another program shows a framebuffer of
  // its own on all of their CRTCs. Needs no DRM master.
  bool IsShown(const std::vector<Splash>& pictures) const;

 private:
  // Not valid where the card could not be opened. Closing it would clear the screens.
  UniqueFd fd_;
};

// Lets one group show on all cards, and another draw by all, before udev, which runs later, does the same. `folder` is /dev/dri. A file that
// cannot be given away stays as it is.
void GiveCards(const std::filesystem::path& folder, gid_t shows, gid_t draws);

}  // namespace kaori::boot
