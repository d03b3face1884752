// What kaori-lips is told on its command line.
#pragma once

#include <optional>
#include <string>

#include "appliance/programs/lips/lip_settings.h"
#include "drivers/base/result.h"

namespace kaori::lips {

struct LipOptions {
  std::string board = "/dev/shm/kaori-board";
  std::string links, device, settings, paint, rest;
  std::string microphone, loudspeaker, sound_delay, pack, trust;
  bool modes = false;
  bool verified = false;
  bool service = false;
};

// The program's exit status where it is to end at once: after --help, or a word that is not known.
std::optional<int> ParseOptions(int argc, char** argv, LipOptions& into);

// What the settings file says, and above it what the command line says. Errors: invalid_argument, those of
// the file.
Result<LipSettings> SettingsOf(const LipOptions& options);

}  // namespace kaori::lips
