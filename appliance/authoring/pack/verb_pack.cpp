#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "appliance/authoring/author.h"
#include "appliance/authoring/pack/check_folder.h"
#include "appliance/authoring/pack/progress.h"
#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// The key first: it would be a pity to find out after a minute of painting. None where no key was named.
Result<std::optional<show::SecretKey>> ReadSigner(const Arguments& arguments) {
  const auto option = arguments.options.find("--sign");
  if (option == arguments.options.end()) return std::optional<show::SecretKey>();
  auto key = show::ReadSecretKey(option->second);
  if (!key) return tl::unexpected(key.error());
  return std::optional(*key);
}

// Checks, makes and writes, each step told. Flaws are told and do not stop it. `signer` may be null. Errors:
// those of CheckFolder's faults, AuthorShow and SavePack.
Result<void> MakePack(const std::filesystem::path& folder, const std::filesystem::path& file,
                      const show::SecretKey* signer, ProgressLine& progress) {
  progress.Step("checking the files of " + folder.string());
  const auto [faults, flaws] = CheckFolder(folder);
  if (!faults.empty()) return FailInput(JoinFaults(faults));
  for (const std::string& flaw : flaws) progress.Note(flaw);
  const auto show = AuthorShow(folder, [&](std::string_view step) { progress.Step(step); });
  if (!show) return tl::unexpected(show.error());
  progress.Step("writing " + file.string());
  return show::SavePack(*show, file, signer);
}

// The progress line ends before the result or the error is printed.
int RunPack(const Arguments& arguments) {
  const auto signer = ReadSigner(arguments);
  if (!signer) return ExitWithError(signer.error());
  // The line of progress must be gone before the result is printed: its block ends first.
  const std::filesystem::path file = arguments.words[1];
  Result<void> made;
  double took_s = 0;
  {
    ProgressLine progress;
    made = MakePack(arguments.words[0], file, *signer ? &**signer : nullptr, progress);
    took_s = progress.seconds();
  }
  if (!made) return ExitWithError(made.error());
  // The size is only told: without it the pack is written all the same.
  std::error_code error;
  fmt::print("{}: {:.1f} MB{}, made in {:.1f} s\n", file.string(),
             static_cast<double>(std::filesystem::file_size(file, error)) * 1e-6, *signer ? ", signed" : "",
             took_s);
  return 0;
}

}  // namespace

Verb PackVerb() {
  return {.name = "pack",
          .words = {"FOLDER", "FILE"},
          .options = {{"--sign", "KEYFILE"}},
          .summary = "build the show that FOLDER describes and write it as one pack",
          .page = R"(
FOLDER holds show.toml, expressions.toml, faces/ and looks/. Its files are checked first, all of them. FILE is replaced
in one step when the new pack lies whole on the disk, and kept where anything fails.

  --sign KEYFILE   sign the pack with the key that `kaori-atelier keygen` wrote; a stage that is started with
                   --trust plays nothing else
)",
          .run = RunPack};
}

}  // namespace kaori::authoring
