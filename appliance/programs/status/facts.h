// What is true of the box beside its board: what it was told when it started, and its screens.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/ports/output.h"

namespace kaori::status {

struct Places {
  std::filesystem::path settings = "/run/kaori-profile";  // What kaori-boot leaves there.
  std::filesystem::path screens = "/run/kaori/screens";   // The stage's screens_file.h.
};

struct Facts {
  std::string profile;    // "stage", "kiosk", "bench"; empty: nobody said, as on a desk.
  std::string root_hash;  // 64 digits; empty: the root is not checked.
  std::string screen;     // The one that shows the status, by name or number; empty: none.
  std::vector<std::string> faults;
  std::vector<ports::Output> screens;  // In the order of their parts of the picture.

  friend bool operator==(const Facts&, const Facts&) = default;
};

// What is not there is empty.
Facts ReadFacts(const Places& places);

}  // namespace kaori::status
