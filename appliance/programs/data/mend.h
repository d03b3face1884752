// A data partition that cannot be mounted is mended, or made anew where it is beyond mending.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "appliance/programs/data/folders.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::data {

// How the partition and its place are named, and how programs are run: a test runs others.
struct Partition {
  std::string device;   // "/dev/vda5".
  std::string folders;  // What a new file system has in it, with owners and modes (folders.h).
  std::span<const Folder> kept = kFolders;   // The same; each is there again once the partition is mended.
  std::string unit = "var-lib-kaori.mount";  // systemd's, which mounts it for all programs,
  std::string place = "/var/lib/kaori";      // here.
  // Between two checks of a file system that was not mended by the first.
  Duration pause = std::chrono::seconds(2);
  // Runs a program to its end and gives its exit status (drivers/base/run_program.h).
  std::function<Result<int>(const std::vector<std::string>&)> run;
};

enum class Mended {
  kSaved,  // e2fsck has saved all of it that it knows of: every folder is there, and nothing has lost its name.
  kInPart,  // Folders were gone, and are there again, empty; or files have lost their names, and are in lost+found.
  kMadeAnew  // Nothing of it was to be saved.
};

// Lets e2fsck mend the file system and has it mounted. Only where e2fsck finds it beyond mending a new file
// system takes its place, with what lies in `folders`. The partition must not be mounted. Blocks for minutes
// on a slow disk. A power cut at any moment leaves a partition that this call mends. Errors: those of running
// the programs; io_error, where e2fsck came to no end, or no file system could be made or mounted: what is
// kept is untouched then, and the call may be repeated.
Result<Mended> Mend(const Partition& partition);

// Faults as kaori-boot left them, a line each, after the mending: what it said of this partition is replaced
// by what has become of it.
std::string FaultsAfter(const std::string& faults, Mended mended);

}  // namespace kaori::data
