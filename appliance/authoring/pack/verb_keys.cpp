#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "appliance/authoring/keys/key_pictures.h"
#include "appliance/authoring/pack/progress.h"
#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/show/pack_keys.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// By its name: what is there may be neither yet.
bool IsPack(const std::string& file) {
  return std::filesystem::path(file).extension() == ".kaori";
}

// The show is read anew for the pack, since the studio has the first one.
Result<int> WriteInto(stage::Studio& studio, const std::string& from, const std::string& into,
                      ProgressLine& progress) {
  std::vector<show::KeyPicture> keys;
  const auto keep = [&](show::KeyPicture key) -> Result<void> {
    keys.push_back(std::move(key));
    return {};
  };
  auto drawn = DrawKeys(studio, keep, [&](std::string_view what) { progress.Step(what); });
  if (!drawn) return drawn;
  progress.Step("writing " + into);
  auto show = show::LoadPack(from);
  if (!show) return tl::unexpected(show.error());
  const auto saved = show::SavePackWithKeys({std::move(*show), std::move(keys)}, into);
  return saved ? drawn : tl::unexpected(saved.error());
}

Result<int> WriteKeys(const Arguments& arguments) {
  const std::string &from = arguments.words[0], &into = arguments.words[1];
  auto show = show::LoadPack(from);
  if (!show) return tl::unexpected(show.error());
  const auto studio = stage::Studio::Open(std::move(*show));
  if (!studio) return tl::unexpected(studio.error());
  ProgressLine progress;
  if (IsPack(into)) return WriteInto(**studio, from, into, progress);
  const auto files = KeyFiles(into);
  if (!files) return tl::unexpected(files.error());
  return DrawKeys(**studio, *files, [&](std::string_view what) { progress.Step(what); });
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
          .words = {"FILE", "INTO"},
          .options = {},
          .summary = "pictures for the keys of a Stream Deck, of all that buttons may call",
          .page = R"(
Draws for each size of keys (72, 96, 120, 80 px) two pictures of each face, expression, scene and way of drawing, and of the
other calls by their names: dimmed, and bright with a frame while it is on.

INTO is a pack's file, which ends in .kaori and may be FILE itself: it gets the show with these pictures, and without a
signature, so that a box which plays it shows them, wherever the show came from. Or INTO is a folder, which is made if need
be: ./box image writes those of its own show into /usr/share/kaori/surfaces/stream-deck of the image.
)",
          .run = RunKeys};
}

}  // namespace kaori::authoring
