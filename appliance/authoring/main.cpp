// kaori-atelier: makes shows.
#include <array>
#include <csignal>
#include <span>

#include "appliance/authoring/import/verb_import.h"
#include "appliance/authoring/pack/verbs.h"
#include "drivers/base/program.h"

int main(int argc, char** argv) {
  using namespace kaori::authoring;
  kaori::BeginProgram("kaori-atelier");
  std::signal(SIGXFSZ, SIG_IGN);  // A file that may not grow is an error like a full disk, not our end.
  const std::array verbs{PackVerb(),  CheckVerb(),  InfoVerb(),   DiffVerb(),
                         SheetVerb(), LabelsVerb(), KeygenVerb(), ImportVerb()};
  return Dispatch(verbs, std::span<char* const>(argv, static_cast<std::size_t>(argc)).subspan(1));
}
