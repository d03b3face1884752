// What is true of the box beside its board: what it was told when it started, and its screens.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kaori::status {

struct Places {
  std::filesystem::path settings = "/run/kaori-profile";  // What kaori-boot leaves there.
  std::filesystem::path screens = "/run/kaori/screens";   // What kaori-stage leaves there: a line for each.
};

struct Facts {
  std::string profile;    // "stage", "kiosk", "bench"; empty: nobody said, as on a desk.
  std::string root_hash;  // 64 digits; empty: the root is not checked.
  std::string screen;     // The one that shows the status, by name or number; empty: none.
  std::vector<std::string> faults;
  std::vector<std::string> screens;

  friend bool operator==(const Facts&, const Facts&) = default;
};

// What is not there is empty.
Facts ReadFacts(const Places& places);

}  // namespace kaori::status
