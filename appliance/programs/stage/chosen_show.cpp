#include "appliance/programs/stage/chosen_show.h"

#include <algorithm>
#include <utility>

#include "appliance/core/roles/level_names.h"
#include "appliance/core/roles/roles_file.h"
#include "appliance/core/store/choice.h"
#include "appliance/programs/stage/key_files.h"
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

// The root's show is opened as the options of the command line say, which trust the verified root; its copy by the same
// keys, but read and checked as a whole; all others as foreign files.
show::LoadOptions OptionsFor(const std::string& id, const ShowPlaces& places) {
  if (id == store::kRootShow) return places.of_root;
  if (id == store::kCopiedShow) return {.signed_by = places.of_root.signed_by, .on_verified_root = false};
  return OptionsOf(places);
}

Result<ChosenShow> Load(const std::string& id, const ShowPlaces& places, bool is_doubted = false) {
  auto pack = store::PackOf(id, places.shows, places.root_pack);
  if (places.before_reading && (is_doubted || id != store::kRootShow)) places.before_reading(pack);
  if (is_doubted)
    if (auto ok = places.read_through(pack); !ok) return tl::unexpected(ok.error());
  auto whole = show::LoadPackWithKeys(pack, OptionsFor(id, places));
  if (!whole) return tl::unexpected(whole.error());
  if (!places.key_files.empty())
    if (auto ok = LayOutKeys(whole->keys, places.key_files); !ok)
      LogWarning("{}; keys with screens show what they can without", ok.error().message());
  return ChosenShow{.show = std::move(whole->show), .id = id, .pack = std::move(pack)};
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

// A file beside the log; an empty text removes it.
void Say(const ShowPlaces& places, const char* name, const std::string& text) {
  if (places.play_log.empty()) return;
  const auto file = places.play_log.parent_path() / name;
  std::error_code none;
  if (text.empty())
    std::filesystem::remove(file, none);
  else if (auto told = WriteWholeFile(file, {AsBytes(text)}); !told)
    LogWarning("{}", told.error().message());
}

// Each is noted before it is read, so that an end while it is read counts against it.
//
// The first show that can be read, and in `log` that it plays. A copy that was never made is not looked for.
Result<ChosenShow> LoadFirst(const std::vector<std::string>& shows, const ShowPlaces& places,
                             store::PlayLog& log, Time now) {
  Result<ChosenShow> chosen = FailInput("there is no show");
  for (const std::string& id : shows) {
    if (id == store::kCopiedShow && !IsThere(store::PackOf(id, places.shows, places.root_pack))) continue;
    log.playing = log.last = id;
    WritePlayLog(places, log);
    chosen = Load(id, places, id == store::kRootShow && store::IsDoubted(log, id, now));
    if (chosen) return chosen;
    LogWarning("{}; the next show is tried", chosen.error().message());
  }
  return chosen;
}

// What people read of it, in both languages.
void SayHowTheRootsShowDoes(const ShowPlaces& places, const Result<ChosenShow>& chosen) {
  const bool is_copy = chosen && chosen->id == store::kCopiedShow;
  if (is_copy)
    LogError(
        "the box's own show is spoilt on its disk, and its copy plays: bring an update, or write the disk "
        "anew");
  Say(places, store::kSpoiltFile,
      is_copy ? "The box's own show is spoilt on its disk; its copy plays. Bring an update of the box.\n"
                "箱の公演データが壊れています。控えで上演中です。箱のアップデートを入れてください。\n"
              : "");
  Say(places, store::kNoShowFile, chosen ? "" : chosen.error().message() + "\n");
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
  const std::string before = log.last;
  auto chosen = LoadFirst(store::ToTry(log, choice), places, log, now);
  SayHowTheRootsShowDoes(places, chosen);
  if (!chosen) return chosen;
  chosen->generation = std::max(choice.generation, told);
  chosen->another = !before.empty() && before != chosen->id;
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
    if (log.playing == store::kRootShow) Say(places_, store::kSettledFile, log.playing + "\n");
  }
  return store::ReadTold(places_.chosen) > generation_;
}

}  // namespace kaori::stage
