#include <fmt/format.h>

#include "appliance/authoring/pack/check_folder.h"
#include "appliance/authoring/pack/progress.h"
#include "appliance/authoring/pack/verbs.h"
#include "appliance/authoring/sheet/plan.h"

namespace kaori::authoring {
namespace {

// Lines go to standard output, the sum to standard error, so that `check > file` keeps the lines alone.
// A flaw ends with 1 as a fault does: a build that checks a show stops at either.
int RunCheck(const Arguments& arguments) {
  const auto [faults, flaws] = CheckFolder(arguments.words[0]);
  if (faults.empty() && flaws.empty()) {
    fmt::print("{}: no fault\n", arguments.words[0]);
    return 0;
  }
  // One of the two lists is empty: flaws are looked for only where there is no fault.
  for (const auto* lines : {&faults, &flaws})
    for (const std::string& line : *lines) fmt::print("{}\n", line);
  fmt::print(stderr, "kaori-atelier: {} in {}\n",
             faults.empty() ? Counted(flaws.size(), "flaw") : Counted(faults.size(), "fault"),
             arguments.words[0]);
  return 1;
}

}  // namespace

Verb CheckVerb() {
  return {.name = "check",
          .words = {"FOLDER"},
          .options = {},
          .summary = "name every fault of FOLDER's files: file, line, item, reason",
          .page = R"(
Reads every file of the show, sculpts its faces, and looks for skin that an expression folds: two seconds. Faults and
folds go to standard output, one a line; exit status 1 where there is any. `kaori-atelier pack` refuses faults and names
folds. How the faces look in all combinations of what is played (folds, gaps of the lids, teeth through lips) is counted
by `kaori-atelier info` on the pack.
)",
          .run = RunCheck};
}

}  // namespace kaori::authoring
