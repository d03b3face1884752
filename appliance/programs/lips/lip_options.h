// The command line of kaori-lips.
#pragma once

#include <optional>
#include <string>

#include "appliance/programs/lips/lip_settings.h"
#include "drivers/base/result.h"

namespace kaori::lips {

// The options as texts; whether they mean anything is found out where they are used.
struct LipOptions {
  // Each as given, and empty where it was not; the help text says what they mean.
  std::string board = "/dev/shm/kaori-board";
  std::string links, device, settings, paint, rest;
  std::string microphone, loudspeaker, sound_delay, pack, trust, shows;
  bool modes = false;
  bool verified = false;
  bool service = false;
};

// Parses the command line into `into`. Returns the exit status where the program has to end: after --help, or
// for an unknown option. Values are not looked at here, but by whoever uses them.
std::optional<int> ParseOptions(int argc, char** argv, LipOptions& into);

// The settings of the file, overridden by those of the command line. Blocks for the disk. Errors:
//   invalid_argument  --paint or --rest has a wrong value; the message names it
// A damaged settings file is logged and is no error.
Result<LipSettings> SettingsOf(const LipOptions& options);

}  // namespace kaori::lips
