#include "appliance/programs/shows/backup_commands.h"

#include <cstdio>
#include <utility>

#include "appliance/core/restore/apply.h"

namespace kaori::shows {
namespace {

// In both languages; to the errors where it is a refusal.
// The status is that of the program: 0, or 1 for a refusal.
int Report(const Progress& progress, const std::string& name) {
  const bool refused = IsRefusal(progress.message);
  std::fprintf(refused ? stderr : stdout, "%s\n%s\n",
               Say(progress.message, Language::kEnglish, name, progress.detail).c_str(),
               Say(progress.message, Language::kJapanese, name).c_str());
  return refused ? 1 : 0;
}

}  // namespace

// Nothing plays on a computer that has a box's disk: all steps at once.
int WriteBackup(const CopyPlaces& places, const std::filesystem::path& folder) {
  BoxCopies copies(places, {});
  Progress progress = copies.Begin({.kind = Choosable::Kind::kBackup, .offer = {}, .remark = {}}, folder, {});
  while (copies.busy()) progress = copies.Step();
  return Report(progress, copies.name());
}

// The differences are listed in each case, before anything is said of what was done.
int RestoreBackup(RestoreTerms terms, const std::filesystem::path& file, RestoreWhen when) {
  // The path is kept here, since the terms are moved into the restoration below.
  const std::filesystem::path data = terms.data;
  const std::string name = file.filename().string();
  auto input = backup::OpenInput(file);
  if (!input) return Report({BackupMessageOf(input.error()), input.error().message()}, name);
  Restoration restoration(std::move(terms), std::move(*input));
  while (!restoration.ended()) restoration.Step();
  const int status = Report(restoration.progress(), name);
  for (const std::string& line : restoration.Differences()) std::printf("  %s\n", line.c_str());
  if (when == RestoreWhen::kNever || restoration.progress().message != Message::kAskChange) return status;
  const Progress waits = restoration.Confirm();
  if (when == RestoreWhen::kNextStart || waits.message != Message::kRestoreWaits) return Report(waits, name);
  const auto done = restore::FinishRestore(data);
  return done ? Report({Message::kRestored}, name)
              : Report({Message::kDiskFault, done.error().message()}, name);
}

}  // namespace kaori::shows
