#include <fmt/format.h>

#include "appliance/authoring/keys/key_pictures.h"
#include "appliance/authoring/pack/progress.h"
#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

Result<int> WriteKeys(const Arguments& arguments) {
  auto show = show::LoadPack(arguments.words[0]);
  if (!show) return tl::unexpected(show.error());
  const auto studio = stage::Studio::Open(std::move(*show));
  if (!studio) return tl::unexpected(studio.error());
  ProgressLine progress;
  return DrawKeys(**studio, arguments.words[1], [&](std::string_view what) { progress.Step(what); });
}

int RunKeys(const Arguments& arguments) {
  const auto drawn = WriteKeys(arguments);
  if (!drawn) return ExitWithError(drawn.error());
  fmt::print("{} calls have pictures in {}\n", *drawn, arguments.words[1]);
  return 0;
}

}  // namespace

Verb KeysVerb() {
  return {.name = "keys",
          .words = {"FILE", "FOLDER"},
          .options = {},
          .summary = "pictures for the keys of a Stream Deck, of all that buttons may call",
          .page = R"(
Writes into FOLDER, which is made if need be, a folder for each size of keys (72, 96, 120, 80 px), and into it two
pictures of each face, expression, scene and way of drawing, and of the other calls by their names: dimmed, and bright with a
frame while it is on. The image has those of its own show; for pictures of a theatre's shows run it for each of them, into
appliance/shows/kaori/surfaces/stream-deck, before ./box image.
)",
          .run = RunKeys};
}

}  // namespace kaori::authoring
