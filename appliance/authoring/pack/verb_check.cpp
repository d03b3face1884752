#include <fmt/format.h>

#include "appliance/authoring/pack/check_folder.h"
#include "appliance/authoring/pack/progress.h"
#include "appliance/authoring/pack/verbs.h"

namespace kaori::authoring {
namespace {

int RunCheck(const Arguments& arguments) {
  const auto faults = CheckFolder(arguments.words[0]);
  if (faults.empty()) {
    fmt::print("{}: no fault\n", arguments.words[0]);
    return 0;
  }
  for (const std::string& fault : faults) fmt::print("{}\n", fault);
  fmt::print(stderr, "kaori-atelier: {} {} in {}\n", faults.size(), faults.size() == 1 ? "fault" : "faults",
             arguments.words[0]);
  return 1;
}

}  // namespace

Verb CheckVerb() {
  return {.name = "check",
          .words = {"FOLDER"},
          .options = {},
          .summary = "name every fault of FOLDER's files: file, item, reason",
          .page = R"(
Reads every file of the show and sculpts its faces, without painting them: a second's work. Faults go to standard
output, one a line. How the faces look in their expressions (folds, gaps of the lids, teeth through lips) is counted
by `kaori-atelier info` on the pack.
)",
          .run = RunCheck};
}

}  // namespace kaori::authoring
