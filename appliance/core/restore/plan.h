// What a restore changes on a box, as a text on its data partition, and the folders in which it waits.
//
// A data partition has, of restores:
//   restore/incoming   what is copied from a stick; of no meaning after a power cut
//   restore/dropped    a restore that was confirmed and gave way to a later one; of no meaning
//   restore/next       a restore that was confirmed: `plan`, and below `files` what it puts. The next start does it
//   restore/kept.new   what the start that does it has taken away so far
//   restore/kept       what the last restore took away, in the form of `next`: given that name, it is put back
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kaori::restore {

inline constexpr const char* kIncoming = "restore/incoming";
inline constexpr const char* kDropped = "restore/dropped";
inline constexpr const char* kNext = "restore/next";
inline constexpr const char* kKeeping = "restore/kept.new";
inline constexpr const char* kKept = "restore/kept";
inline constexpr const char* kPlan = "plan";
inline constexpr const char* kFiles = "files";

struct Plan {
  // Is chosen then: an id or store::kRootShow; empty: the choice stays.
  std::string show;
  // Paths that are put, and
  std::vector<std::string> put;
  // that are taken away; each of them IsRestored or IsPack.
  std::vector<std::string> removed;
  friend bool operator==(const Plan&, const Plan&) = default;
};

inline constexpr std::size_t kMostPlan_bytes = std::size_t{128} << 10U;

// The text, with a checksum at its end, and back; nothing for one that is torn, foreign, or names other paths. Pure.
std::string Format(const Plan& plan);
std::optional<Plan> ParsePlan(std::string_view text);

}  // namespace kaori::restore
