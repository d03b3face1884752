#include <fmt/format.h>

#include "appliance/authoring/pack/difference.h"
#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// Differences are no failure: exit status 0 with and without them.
int RunDiff(const Arguments& arguments) {
  const auto before = show::LoadPack(arguments.words[0]);
  if (!before) return ExitWithError(before.error());
  // Both packs are in memory at a time, and LoadPack has checked them, as Differences wants it.
  const auto after = show::LoadPack(arguments.words[1]);
  if (!after) return ExitWithError(after.error());
  const auto differences = Differences(*before, *after);
  for (const std::string& line : differences) fmt::print("{}\n", line);
  if (differences.empty()) fmt::print("the two play alike\n");
  return 0;
}

}  // namespace

Verb DiffVerb() {
  return {.name = "diff",
          .words = {"A", "B"},
          .options = {},
          .summary = "what changed from pack A to pack B, item by item",
          .page = R"(
One line for each face, expression, control point, prop, motion, scene and control that differs, with how much: lengths
in millimetres on the reference face. Items are matched by their names.
)",
          .run = RunDiff};
}

}  // namespace kaori::authoring
