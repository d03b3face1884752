// What the first program finds wrong: a line in the kernel's log, in English and Japanese, and both for the box's status.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace kaori::boot {

// What it is about, for whoever stands before the box; each but the first has words in Japanese, which say what to do.
enum class Trouble : std::uint8_t {
  kOther,
  // settings/box.toml has a mistake.
  kSettings,
  // The PC forgot the time.
  kClock,
  // A card has no driver, or wants a file of its maker's.
  kGraphics,
  // The data partition is not there, or was mended.
  kData,
  kNetwork,
  // A restore was done, or could not be.
  kRestored,
  kNotRestored
};
inline constexpr std::size_t kTroubles = 8;

// A line of English, and what it is about.
struct Fault {
  std::string line;
  Trouble trouble = Trouble::kOther;
};

// UTF-8; empty for kOther. Pure.
std::string_view InJapanese(Trouble trouble);

// A record of the kernel's log (kmsg(4)): a warning of kaori-boot's. Pure.
std::string RecordOf(const Fault& fault);

// Writes it there, from where the journal reads it: there is no journal yet. Nothing of it comes to the show's screens.
void Report(const std::string& line, Trouble trouble = Trouble::kOther);

// All lines so far, each with a line end: the English one, and below it the Japanese one where it was not said before.
const std::string& Reported();

}  // namespace kaori::boot
