// What the status knows beside the board: how the box was started, and its screens. The board says how
// devices and programs do; what is no device, and does not change, is in these files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/ports/output.h"

namespace kaori::status {

// Where the facts lie; each file may be missing, as on a developer's machine.
struct Places {
  std::filesystem::path settings = "/run/kaori-profile";  // What kaori-boot leaves there.
  std::filesystem::path screens = "/run/kaori/screens";   // The stage's screens_file.h.
  std::filesystem::path notices = "/run/kaori-notices";   // What kaori-power leaves there.
  // What kaori-update says of an update that waits, is tried or gave way.
  std::filesystem::path update = "/run/kaori-update/notice";
  // What kaori-shows says while the service key is on.
  std::filesystem::path shows = "/run/kaori-shows/lines";
  // What kaori-data says to whoever asks for a factory reset.
  std::filesystem::path reset = "/run/kaori-reset/notice";
  // What kaori-usb says of devices that stay unauthorised, a file for each port.
  std::filesystem::path usb = "/run/kaori-usb";
  // What the stage says of a show of the root that its disk has spoilt.
  std::filesystem::path spoilt = "/run/kaori/show-spoilt";
};

// Compared as a whole, to see whether anything has changed.
struct Facts {
  std::string name{};     // Which box it is (core/store/box_name.h); empty where no box was started.
  std::string profile;    // "stage", "kiosk" or "bench"; empty where no box was started.
  std::string root_hash;  // 128 digits; empty where the root file system is not verified.
  std::string slot;       // "A" or "B", the disk's slot that was started; empty where that is not known.
  std::string screen;     // The screen of the status display, by name or number; empty: there is none.
  std::string monitor{};  // That of the operators' monitor.
  // What kaori-boot could not do, one line each, in the order in which it happened, then what other programs found; below
  // a line what to do, in Japanese.
  std::vector<std::string> faults;
  // As the stage wrote them last; they stay there when the stage is gone.
  std::vector<ports::Output> screens;  // In the order of their parts of the picture.
  // What whoever stands before the box is to know of what he has just done, one line each.
  std::vector<std::string> notices;
  // Which shows a stick holds, and how bringing one in stands, in English and Japanese.
  std::vector<std::string> shows{};
  // How an update of the box stands, as for `shows`.
  std::vector<std::string> update{};
  // USB devices that stay unauthorised although somebody may want them to work, in the order of their ports.
  // Those that say they are what they are not are among `faults`.
  std::vector<std::string> usb{};

  friend bool operator==(const Facts&, const Facts&) = default;
};

// Reads the files; a missing one leaves its value empty. Blocks for the disk. Of a file of many lines the
// first 64 are read.
Facts ReadFacts(const Places& places);

}  // namespace kaori::status
