#include "appliance/programs/shows/install_service.h"

#include <algorithm>
#include <utility>

#include "appliance/core/store/play_log.h"
#include "appliance/core/store/said.h"
#include "drivers/base/log.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

constexpr Duration kLookPeriod = std::chrono::milliseconds(500);
constexpr std::size_t kLongestReason = 160;  // Two lines of a small screen.

constexpr std::size_t kRoomForKeys = 2;  // In a list that has more shows than it has numbers.

// As people compare it with what a stick holds: decimal, without a fraction.
std::string Megabytes(std::uint64_t bytes) {
  return fmt::format("{:.0f} MB", static_cast<double>(bytes) * 1e-6);
}

// A report that cannot be written costs the lines on the screen, and not the installation.
void WriteReport(const std::filesystem::path& file, const std::string& text) {
  if (auto ok = WriteWholeFile(file, {AsBytes(text)}); !ok) LogWarning("{}", ok.error().message());
}

// Spaces stand in fingerprints for people's eyes only.
std::string KeyName(const show::PublicKey& key) {
  std::string name = show::Fingerprint(key);
  std::erase(name, ' ');
  return name + ".pub";
}

}  // namespace

InstallService::InstallService(ServicePlaces places, Folder& folder, const board::Board& board,
                               LookForStick look, Trial trial)
    : places_(std::move(places)),
      folder_(folder),
      board_(board),
      look_(std::move(look)),
      trial_(std::move(trial)) {
  RemoveLeftovers(folder_);
}

// The copy that is on its way is of no use to anybody.
InstallService::~InstallService() {
  if (installation_) RemoveLeftovers(folder_);
}

// Read anew for each installation: a key that was just taken counts at once. A file without a key is named,
// and the others still count; where nothing can be read nobody is trusted.
show::PublicKeys InstallService::Keys() const {
  std::vector<std::string> faults;
  const std::vector<std::filesystem::path> folders{places_.root_keys, places_.keys};
  const auto keys = show::ReadPublicKeys(folders, &faults);
  for (const std::string& fault : faults) LogWarning("{}", fault);
  return keys.value_or(show::PublicKeys{});
}

// The stage notes it in memory when it loads a show; without a stage the chosen show is what will play.
std::string InstallService::Plays() const {
  return store::ReadPlayLog(places_.plays).last;
}

// A stick is looked for while one is read as well, so that another one is listed as soon as the installation
// has ended.
void InstallService::Step(Time now) {
  if (now >= look_next_) Look(now);
  if (installation_) return StepInstallation();
  if (!stick_) return;
  if (const auto taken =
          menu_.Read(board_.Read<board::Keys>(), board_.Read<board::Surface>(), board_.Read<board::Lines>()))
    Accept(*taken);
}

// The stick may go while its show is checked; while it is copied, the copy itself notices.
void InstallService::Look(Time now) {
  look_next_ = now + kLookPeriod;
  FollowChosen();
  auto looked = look_();
  if (!looked && !installation_) Tell(Message::kUnreadable, {}, looked.error().message());
  auto stick = looked.value_or(std::nullopt);
  if (looked && !stick && !installation_ && said_ == Message::kUnreadable) Tell(Message::kPlugIn);
  if (stick == stick_) return;
  stick_ = std::move(stick);
  if (installation_) return;
  if (stick_) return OfferAll(*stick_);
  menu_.Offer({});
  if (looked && (said_ == Message::kChoose || said_ == Message::kNoShow)) Tell(Message::kPlugIn);
}

// The stage notes a show when it begins to read it, and another one where it gives it up; it plays once the next
// frame has been presented.
void InstallService::FollowChosen() {
  if (!awaited_ || installation_) return;
  const store::PlayLog log = store::ReadPlayLog(places_.plays);
  if (log.generation < awaited_->generation || log.playing.empty()) return;
  const bool begun = log.playing == awaited_->current;
  const std::uint32_t frames = board_.Read<board::StageStatus>().value.frames;
  if (begun && !frames_at_begin_) frames_at_begin_ = frames;
  if (begun && frames == *frames_at_begin_) return;
  awaited_.reset();
  Tell(begun ? Message::kPlays : Message::kUnplayable, name_);
}

void InstallService::OfferAll(const std::filesystem::path& stick) {
  const auto listed = List(stick);
  if (!listed) return Tell(Message::kPulled, {}, listed.error().message());
  Tell(*listed == 0 ? Message::kNoShow : Message::kChoose);
}

// Shows first, so that their numbers do not depend on the keys beside them; of many shows some have to give
// their numbers to keys, without which they might not be trusted. A file that holds no key is not offered.
Result<std::size_t> InstallService::List(const std::filesystem::path& stick) {
  const auto shows = ListShows(stick), keys = ListKeys(stick);
  if (!shows || !keys) return tl::unexpected((!shows ? shows : keys).error());
  std::vector<Choosable> choices, of_keys;
  for (const auto& offer : *shows) choices.push_back({Choosable::Kind::kShow, offer, Megabytes(offer.bytes)});
  for (const auto& offer : *keys)
    if (const auto key = show::ReadPublicKey(offer.file))
      of_keys.push_back({Choosable::Kind::kKey, offer, show::Fingerprint(*key), *key});
  const std::vector<Choosable> before = Before();
  const std::size_t all = choices.size() + of_keys.size(), numbers = kMostChoices - before.size();
  choices.resize(std::min(choices.size(), numbers - std::min(of_keys.size(), kRoomForKeys)));
  of_keys.resize(std::min(of_keys.size(), numbers - choices.size()));
  choices.insert(choices.end(), of_keys.begin(), of_keys.end());
  const std::size_t listed = choices.size();
  choices.insert(choices.end(), before.begin(), before.end());
  menu_.Offer(std::move(choices), all - listed);
  return listed;
}

// A pack that was removed to make room is no show to go back to.
std::vector<Choosable> InstallService::Before() const {
  const store::Choice choice = ReadChoice(folder_);
  std::vector<Choosable> shows;
  const auto offer = [&](const char* name, std::string id) {
    shows.push_back({.kind = Choosable::Kind::kBack,
                     .offer = {.file = {}, .name = name},
                     .remark = {},
                     .id = std::move(id)});
  };
  if (choice.previous != choice.current && folder_.BytesOf(store::PackName(choice.previous)) > 0)
    offer("back to the show before", choice.previous);
  if (choice.current != store::kRootShow) offer("back to the box's own show", std::string(store::kRootShow));
  return shows;
}

void InstallService::Accept(const Choosable& taken) {
  if (taken.kind == Choosable::Kind::kShow) return Install(taken);
  if (taken.kind == Choosable::Kind::kKey) return AcceptKey(taken);
  GoBack(taken);
}

// It was tried when it came. The stage passes over a pack that the disk has spoilt, and that is said then.
void InstallService::GoBack(const Choosable& taken) {
  name_ = taken.offer.name;
  const store::Choice choice = ReadChoice(folder_);
  if (auto ok = WriteChoice(folder_, {choice.generation + 1, taken.id, choice.current}); !ok)
    return Tell(ok.error().cause == std::errc::no_space_on_device ? Message::kFull : Message::kDiskFault,
                name_, ok.error().message());
  TellStage();
  if (stick_) static_cast<void>(List(*stick_));  // A stick that cannot be read is named at the next look.
  Tell(Message::kInstalled, name_);
}

// By a number in memory, so that the stage asks no disk while a show plays.
void InstallService::TellStage() {
  awaited_ = ReadChoice(folder_);
  frames_at_begin_.reset();
  WriteReport(places_.report / "chosen", std::to_string(awaited_->generation) + "\n");
}

// The key alone is kept, as it was shown, under a name that no stick chooses.
void InstallService::AcceptKey(const Choosable& taken) {
  std::error_code none;
  std::filesystem::create_directories(places_.keys, none);
  const std::string line = show::PublicKeyLine(taken.key);
  if (auto ok = WriteWholeFile(places_.keys / KeyName(taken.key), {AsBytes(line)}); !ok)
    return Tell(ok.error().cause == std::errc::no_space_on_device ? Message::kFull : Message::kDiskFault,
                taken.offer.name, ok.error().message());
  Tell(Message::kKeyTaken, taken.offer.name, show::Fingerprint(taken.key));
}

// The name is kept: a stick that is gone can no longer be asked for it.
void InstallService::Install(const Choosable& taken) {
  name_ = taken.offer.name;
  awaited_.reset();
  auto source = OpenSource(taken.offer.file);
  if (!source) return Tell(MessageOf(source.error()), name_, source.error().message());
  installation_.emplace(folder_, std::move(*source), Keys(), trial_, Plays());
  Tell(Message::kCopying, name_);
}

void InstallService::StepInstallation() {
  const Message before = installation_->progress().message;
  const Progress progress = installation_->Step();
  if (installation_->ended() && stick_) static_cast<void>(List(*stick_));
  if (progress.message != before || installation_->ended()) Tell(progress.message, name_, progress.detail);
  if (!installation_->ended()) return;
  if (progress.message == Message::kInstalled) TellStage();
  installation_.reset();
  menu_.ForgetPresses();  // Whoever pressed again while nothing seemed to happen takes nothing more.
}

// Both languages, one below the other; the screen shows those lines that its font has letters for.
void InstallService::Tell(Message message, const std::string& name, const std::string& reason) {
  const std::string detail = Printable(reason, kLongestReason);
  said_ = message;
  const std::string mark(IsRefusal(message) ? store::kRefusalMark : std::string_view());
  std::string text = mark;
  for (const std::string& line : menu_.Lines(message, Language::kEnglish, name, detail)) text += line + "\n";
  text += mark + Say(message, Language::kJapanese, name) + "\n";
  if (text == told_) return;
  told_ = text;
  WriteReport(places_.report / "lines", text);
  const std::string line =
      Say(message, Language::kEnglish, name, detail) + " / " + Say(message, Language::kJapanese, name);
  if (IsRefusal(message))
    LogWarning("{}", line);
  else
    Log("{}", line);
}

}  // namespace kaori::shows
