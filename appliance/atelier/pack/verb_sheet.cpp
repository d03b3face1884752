#include <cstdio>

#include <fmt/format.h>

#include "appliance/atelier/pack/verbs.h"
#include "appliance/atelier/sheet/sheet.h"
#include "appliance/show/pack.h"

namespace kaori::atelier {
namespace {

int Run(const Arguments& arguments) {
  auto show = show::LoadPack(arguments.words[0]);
  if (!show) return Complain(show.error());
  const auto studio = stage::Studio::Open(std::move(*show));
  if (!studio) return Complain(studio.error());
  const auto wrote = [](std::string_view name) {
    fmt::print("{}\n", name);
    std::fflush(stdout);
  };
  if (const auto ok = DrawSheets(**studio, arguments.words[1], {}, wrote); !ok) return Complain(ok.error());
  return 0;
}

}  // namespace

Verb SheetVerb() {
  return {.name = "sheet",
          .words = {"FILE", "FOLDER"},
          .options = {},
          .summary = "pictures of every face with every expression, and a page that shows them",
          .page = "\nWrites PNG files and index.html into FOLDER, which is made if need be.\n",
          .run = Run};
}

}  // namespace kaori::atelier
