#include "appliance/programs/stage/chosen_show.h"

#include <algorithm>
#include <utility>

#include "appliance/core/roles/level_names.h"
#include "appliance/core/roles/roles_file.h"
#include "appliance/core/store/choice.h"
#include "drivers/base/folder.h"
#include "drivers/base/log.h"
#include "drivers/base/whole_file.h"

namespace kaori::stage {
namespace {

void WritePlayLog(const ShowPlaces& places, const store::PlayLog& log) {
  if (places.play_log.empty()) return;
  const std::string text = store::Format(log);
  if (auto ok = WriteWholeFile(places.play_log, {AsBytes(text)}); !ok) LogWarning("{}", ok.error().message());
}

// Keys of the root are the house's, those of the data partition a theatre's.
show::LoadOptions OptionsOf(const ShowPlaces& places) {
  std::vector<std::string> faults;
  const std::vector<std::filesystem::path> folders{places.root_pack.parent_path() / "keys", places.keys};
  const auto keys = show::ReadPublicKeys(folders, &faults);
  for (const std::string& fault : faults) LogWarning("{}", fault);
  if (!keys) LogWarning("{}", keys.error().message());
  return {.signed_by = keys.value_or(show::PublicKeys{}), .on_verified_root = false};
}

// The root's show is opened as the options of the command line say, which trust the verified root; all others
// as foreign files.
Result<ChosenShow> Load(const std::string& id, const ShowPlaces& places) {
  auto pack = store::PackOf(id, places.shows, places.root_pack);
  auto show = show::LoadPack(pack, id == store::kRootShow ? places.of_root : OptionsOf(places));
  if (!show) return tl::unexpected(show.error());
  return ChosenShow{.show = std::move(*show), .id = id, .pack = std::move(pack)};
}

// A folder that holds packs has had a choice since before its first one: both of its files are gone or torn.
void TellOfLostChoice(const ShowPlaces& places) {
  if (store::HasChoice(places.shows)) return;
  const auto files = ListFolder(places.shows);
  if (!files || !std::ranges::any_of(*files, [](const auto& file) { return file.extension() == ".kaori"; }))
    return;
  LogWarning(
      "{} holds shows, and which one is to be played is lost: the box's own show plays; bring the show "
      "again by its stick",
      places.shows.string());
}

}  // namespace

// What is noted before the show is read: one that ends the stage while it is read counts as well.
Result<ChosenShow> LoadChosen(const ShowPlaces& places, Time now) {
  if (places.shows.empty()) return Load(std::string(store::kRootShow), places);
  // Before the choice: what comes between the two is followed, and a choice that the disk has lost is not
  // waited for.
  const std::uint64_t told = store::ReadTold(places.chosen);
  const store::Choice choice = store::ReadChoice(places.shows);
  TellOfLostChoice(places);
  store::PlayLog log = store::Started(store::ReadPlayLog(places.play_log), choice, now);
  for (const std::string& id : log.given_up)
    LogWarning("the show {} ended the stage {} times too soon and gives way to the one before it", id,
               store::kMostEnds);
  Result<ChosenShow> chosen = FailInput("there is no show");
  const std::string before = log.last;
  for (const std::string& id : store::ToTry(log, choice)) {
    log.playing = log.last = id;
    WritePlayLog(places, log);
    chosen = Load(id, places);
    if (!chosen) {
      LogWarning("{}; the next show is tried", chosen.error().message());
      continue;
    }
    chosen->generation = std::max(choice.generation, told);
    chosen->another = !before.empty() && before != id;
    return chosen;
  }
  return chosen;
}

OwnRoles OwnRolesOver(const show::Show& show, std::filesystem::path file) {
  return {.file = std::move(file), .items = roles::ItemsOf(show), .below = show.roles};
}

void LayOverRoles(const OwnRoles& own, show::Show& show) {
  if (!IsThere(own.file)) return;
  roles::Besides besides;
  const auto faults = roles::LayOver(own.file, own.items, show.roles, besides);
  roles::Assign(besides.buttons, show);
  for (const std::string& line : besides.warnings) LogWarning("{}", line);
  for (const std::string& fault : faults) LogWarning("{}", fault);
  if (!faults.empty()) LogWarning("the show is played with its own roles");
}

void NoteOrderlyEnd(const ShowPlaces& places) {
  if (places.shows.empty()) return;
  store::PlayLog log = store::ReadPlayLog(places.play_log);
  log.playing.clear();
  WritePlayLog(places, log);
}

// The log is read again before it is written: what the start noted in it stays.
bool ShowWatch::IsOver(Time now) {
  if (!places_.shows.empty() && !settled_ && now - first_picture_ >= store::kSettlesAfter) {
    settled_ = true;
    store::PlayLog log = store::ReadPlayLog(places_.play_log);
    log.settled = !log.playing.empty();
    WritePlayLog(places_, log);
  }
  return store::ReadTold(places_.chosen) > generation_;
}

}  // namespace kaori::stage
