#include <fmt/format.h>

#include "appliance/authoring/pack/progress.h"
#include "appliance/authoring/pack/verbs.h"
#include "appliance/authoring/sheet/sheet.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// The studio opens a GL context of its own, on whatever EGL has: no screen is needed.
Result<void> WriteSheets(const Arguments& arguments) {
  auto show = show::LoadPack(arguments.words[0]);
  if (!show) return tl::unexpected(show.error());
  const auto studio = stage::Studio::Open(std::move(*show));
  if (!studio) return tl::unexpected(studio.error());
  ProgressLine progress;
  // Standard output has the names alone, so that a script can read which files there are.
  const auto wrote = [](std::string_view name) { fmt::print("{}\n", name); };
  // The inspection is what frames faults in red: --quick leaves it out.
  return DrawSheets(**studio, arguments.words[1], {.inspects = !arguments.Has("--quick")}, wrote,
                    [&](std::string_view what) { progress.Step(what); });
}

int RunSheet(const Arguments& arguments) {
  const auto ok = WriteSheets(arguments);
  return ok ? 0 : ExitWithError(ok.error());
}

}  // namespace

Verb SheetVerb() {
  return {.name = "sheet",
          .words = {"FILE", "FOLDER"},
          .options = {{"--quick", ""}},
          .summary = "pictures of every face with every expression, and a page that shows them",
          .page = R"(
Writes into FOLDER, which is made if need be:
  cast.png         a row for each face, a column for each expression
  faces.png        each face from five sides
  styles.png       each face in the five ways of drawing
  morphs.png       from the first face to each other one
  face-NAME.png    one face with every expression, mouth shape, lid and channel
  index.html       all of it for a browser, to be searched and enlarged
What an audience must not see (folded skin, gaps of shut lids, teeth through lips) is framed in red; --quick does not
look for it. Names of what was written go to standard output, progress to standard error.
)",
          .run = RunSheet};
}

}  // namespace kaori::authoring
