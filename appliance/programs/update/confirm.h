// The look at a system that is tried, as it starts: it stays, or gives way to the one before.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "appliance/programs/update/trial.h"
#include "drivers/base/result.h"
#include "drivers/ports/boot_choice.h"

namespace kaori::update {

// Where what is looked at lies; the options of kaori-update say what each is.
struct TrialPlaces {
  // The slot that runs, what is kept between starts, and what is said to other programs in this one.
  std::string slot, notes, said;
  // What the stage draws, the image's first picture, and the last face that the system before has kept.
  std::string picture, still, last_face;
  std::string board, systemctl;
  // The loader's choice. Errors: those of OpenBootChoice.
  std::function<Result<std::unique_ptr<ports::BootChoice>>(ports::Slot)> open_choice;
};

// What the status picture shows, in both languages; a file in the folder `said`, in memory.
void TellStatus(const std::filesystem::path& said, const Outcome& outcome);

// Says what became of an update that waits; and where this system is itself being tried, looks at it until there is a verdict, and
// restarts the machine where it gives way. Blocks for minutes. Gives the program's exit status: another than 0 where nothing was
// settled, and the service manager is to start it again. Of such starts the second gives way without a look, and the third has the
// machine restarted at once: a trial ends, whatever fails. A file `settled` in `said` tells that this start is none, or has ended well;
// kaori-trial.timer restarts a machine on which it is missing.
int Confirm(const TrialPlaces& places);

}  // namespace kaori::update
