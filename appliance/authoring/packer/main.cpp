// kaori-packer: packs the default show and writes its labels, as a step of the build.
//
// It is kaori-atelier but for the verbs that the build does not need: heads from modelling tools are a sixth of all that
// would have to be compiled before a show plays.
#include <array>
#include <span>

#include "appliance/authoring/pack/verbs.h"
#include "drivers/base/program.h"

int main(int argc, char** argv) {
  using namespace kaori::authoring;
  kaori::BeginProgram("kaori-packer");
  const std::array verbs{PackVerb(), LabelsVerb()};
  return Dispatch(verbs, std::span<char* const>(argv, static_cast<std::size_t>(argc)).subspan(1));
}
