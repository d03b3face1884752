#include "appliance/programs/shows/backup_commands.h"

#include <cstdio>
#include <utility>

namespace kaori::shows {
namespace {

// In both languages; to the errors where it is a refusal.
int Report(const Progress& progress, const std::string& name) {
  const bool refused = IsRefusal(progress.message);
  std::fprintf(refused ? stderr : stdout, "%s\n%s\n",
               Say(progress.message, Language::kEnglish, name, progress.detail).c_str(),
               Say(progress.message, Language::kJapanese, name).c_str());
  return refused ? 1 : 0;
}

}  // namespace

int WriteBackup(const CopyPlaces& places, const std::filesystem::path& folder) {
  BoxCopies copies(places, {});
  Progress progress = copies.Begin({.kind = Choosable::Kind::kBackup, .offer = {}, .remark = {}}, folder, {});
  while (copies.busy()) progress = copies.Step();
  return Report(progress, copies.name());
}

int RestoreBackup(RestoreTerms terms, const std::filesystem::path& file, bool only_says) {
  const std::string name = file.filename().string();
  auto input = backup::OpenInput(file);
  if (!input) return Report({BackupMessageOf(input.error()), input.error().message()}, name);
  Restoration restoration(std::move(terms), std::move(*input));
  while (!restoration.ended()) restoration.Step();
  const int status = Report(restoration.progress(), name);
  for (const std::string& line : restoration.Differences()) std::printf("  %s\n", line.c_str());
  if (only_says || restoration.progress().message != Message::kAskRestore) return status;
  return Report(restoration.Confirm(), name);
}

}  // namespace kaori::shows
