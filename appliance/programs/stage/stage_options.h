// The command line of kaori-stage.
#pragma once

#include <optional>
#include <string>

#include "appliance/programs/stage/evening.h"
#include "appliance/programs/stage/still.h"

namespace kaori::stage {

struct StageOptions {
  // Each as given, and empty where it was not; the help text says what they mean.
  std::string log, still, last_face, board, pack, links, card, trust, shows, chosen, rehearse, own, mode,
      fdkeeper, looked_at, trial, settled, keys, settings = "/run/kaori-profile", quality = "auto";
  EveningOptions evening;
  bool early = false, verified = false;
};

// Reads the command line into `into`. The exit status where the program is done with it: 0 for --help, 2
// where it is misused, which was logged. Whether a mode can be shown is for the caller to judge.
std::optional<int> ParseOptions(int argc, char** argv, StageOptions& into);

// Where the options want pictures of what is shown.
StillFiles StillFilesOf(const StageOptions& options);

}  // namespace kaori::stage
