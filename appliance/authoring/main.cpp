// kaori-atelier: makes shows.
#include <array>
#include <csignal>
#include <span>

#include "appliance/authoring/import/verb_export.h"
#include "appliance/authoring/import/verb_import.h"
#include "appliance/authoring/pack/verbs.h"
#include "drivers/base/program.h"

// Runs on an author's machine and in the build, never on the box; each verb is a file of its own.
int main(int argc, char** argv) {
  using namespace kaori::authoring;
  kaori::BeginProgram("kaori-atelier");
  // A file that may not grow (RLIMIT_FSIZE) is an error like a full disk, not our end.
  std::signal(SIGXFSZ, SIG_IGN);
  const std::array verbs{PackVerb(),     CheckVerb(),  InfoVerb(),   DiffVerb(),   SheetVerb(),
                         CueSheetVerb(), LabelsVerb(), KeysVerb(),   KeygenVerb(), SignVerb(),
                         ImportVerb(),   ExportVerb(), ReportVerb(), VerbOfTakes()};
  return Dispatch(verbs, std::span<char* const>(argv, static_cast<std::size_t>(argc)).subspan(1));
}
