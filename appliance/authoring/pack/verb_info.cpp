#include <optional>

#include <fmt/format.h>

#include "appliance/authoring/pack/facts.h"
#include "appliance/authoring/pack/progress.h"
#include "appliance/authoring/pack/verbs.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// The progress line is gone before anything is printed.
Result<Facts> Gather(const std::string& file) {
  ProgressLine progress;
  return GatherFacts(file, [&](const std::string& step) { progress.Step(step); });
}

// What is found in the faces is no failure: the exit status is 0 for every pack that can be read.
int RunInfo(const Arguments& arguments) {
  const auto facts = Gather(arguments.words[0]);
  if (!facts) return ExitWithError(facts.error());
  fmt::print("{}", arguments.Has("--json") ? FactsJson(*facts) : FactsPage(*facts));
  return 0;
}

}  // namespace

Verb InfoVerb() {
  return {.name = "info",
          .words = {"FILE"},
          .options = {{"--json", ""}},
          .summary = "what a pack holds, and how its faces look in all their expressions",
          .page = R"(
Every face is composed with every expression, and three things that an audience must not see are counted:

  folds                triangles of the skin that an expression has turned over
  lid gaps             eyes that show through their shut lids, from any of nine sides
  teeth through lips   faces whose teeth stand before their lips

  --json   the same for programs, with every finding
)",
          .run = RunInfo};
}

}  // namespace kaori::authoring
