#include "appliance/authoring/pack/verbs.h"
#include "appliance/authoring/script/labels.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/program.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

// Silent where all is well: it is run by builds.
int RunLabels(const Arguments& arguments) {
  const auto show = show::LoadPack(arguments.words[0]);
  if (!show) return ExitWithError(show.error());
  // The file is replaced as a whole, so that a build that is stopped leaves no half of it.
  const std::string json = LabelsJson(*show);
  if (const auto ok = WriteWholeFile(arguments.words[1], {AsBytes(json)}); !ok)
    return ExitWithError(ok.error());
  return 0;
}

}  // namespace

Verb LabelsVerb() {
  return {.name = "labels",
          .words = {"FILE", "JSON"},
          .options = {},
          .summary = "what the show writes on the operators' controls, for kaori-sim's page",
          .page = "",
          .run = RunLabels};
}

}  // namespace kaori::authoring
