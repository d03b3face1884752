// What a technician wants to know of a box, as one text: what it is, how it does, how its last starts went.
// Nothing private is in it: no words of a voice, no picture, no key, and of the settings nothing that may be
// a secret.
#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/programs/shows/folder.h"
#include "appliance/programs/status/facts.h"
#include "drivers/base/result.h"

namespace kaori::shows {

// Parts of the journal, all of the last starts.
enum class JournalPart : std::uint8_t { kAll, kWarnings, kPower };

// The newest lines of a part, oldest first, `most_bytes` at most. Blocks for seconds. Errors: any; the report
// says so in its place.
using Journal = std::function<Result<std::string>(JournalPart part, std::size_t most_bytes)>;

// The journal as journalctl(1) has it: that of the folder, or this system's where that is empty. Errors:
// those of OutputOf.
struct JournalSource {
  std::string program = "/usr/bin/journalctl", folder{};
};
Result<std::string> ReadJournal(const JournalSource& source, JournalPart part, std::size_t most_bytes);

// Where it looks; what is missing is said to be.
struct SupportPlaces {
  std::filesystem::path settings = "/var/lib/kaori/settings/box.toml";
  // appliance/core/store/play_log.h
  std::filesystem::path plays = "/run/kaori/plays";
  std::filesystem::path release = "/etc/os-release", machine_id = "/etc/machine-id";
  std::filesystem::path usb = "/sys/bus/usb/devices";
  // Where the show log lies, and beside it the show reports.
  std::filesystem::path reports = "/var/lib/kaori/own/log";
  status::Places status{};
};

// A box's name as a part of a file's name: the host's name and, where that does not end with it, the beginning of the
// box's number: "kaori-1a2b3c4d", "left-lobby-1a2b3c4d". What is no letter and no digit becomes "-". Pure.
std::string NameForFiles(std::string host, const std::string& number);

// The name of this box, by uname(2) and its number (machine-id(5)).
std::string BoxName(const SupportPlaces& places);

inline constexpr std::size_t kMostSupport_bytes = std::size_t{5} << 20U;

// The report, in UTF-8, kMostSupport_bytes at most. `wall` is the time by the box's clock, which may be
// wrong. `board` is null where there is none. Blocks for the disk and for the journal.
std::string SupportReport(const SupportPlaces& places, const Folder& shows, const board::Board* board,
                          const Journal& journal, std::time_t wall);

}  // namespace kaori::shows
