#include "appliance/programs/shows/install_service.h"

#include <utility>

#include "appliance/core/store/play_log.h"
#include "appliance/programs/shows/offers.h"
#include "appliance/programs/shows/support_file.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

constexpr Duration kLookPeriod = std::chrono::milliseconds(500);
// Of a program whose part of the board is over.
constexpr Duration kSilence = std::chrono::milliseconds(500);
constexpr const char* kTold = "chosen";

}  // namespace

InstallService::InstallService(ServicePlaces places, Folder& folder, const board::Board& board,
                               LookForStick look, Trial trial, OfBox of_box)
    : places_(std::move(places)),
      folder_(folder),
      board_(board),
      look_(std::move(look)),
      trial_(std::move(trial)),
      of_box_(std::move(of_box)) {
  RemoveLeftovers(folder_);
  auto on_board = board.AcquireWriter<board::ShowsMenu>();
  if (on_board)
    on_board_.emplace(std::move(*on_board));
  else
    LogWarning("what is pressed in the list of shows is the show's as well: {}", on_board.error().message());
}

// The copy that is on its way is of no use to anybody. The list is over at once, and not only when it is
// silent.
InstallService::~InstallService() {
  if (installation_) RemoveLeftovers(folder_);
  if (on_board_) on_board_->Write({}, {}, board::SourceState::kAbsent);
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
  if (writes_support_) {
    WriteSupport();
  } else if (installation_) {
    StepInstallation();
  } else if (of_box_.copies != nullptr && of_box_.copies->busy()) {
    StepCopies(now);
  } else if (update_) {
    FollowUpdate();
  } else if (IsBusyElsewhere(now)) {
    menu_.Shut();
    menu_.ForgetPresses();
  } else if (const auto taken = menu_.Read(board_.Read<board::Keys>(), board_.Read<board::Surface>(),
                                           board_.Read<board::Lines>(), now)) {
    Accept(*taken);
  }
  if (of_box_.desk != nullptr) HearDesk();
  FollowMenu(now);
  if (of_box_.desk != nullptr) TellDesk(now);
  KeepAlive(now);
}

void InstallService::KeepAlive(Time now) {
  if (on_board_) on_board_->Write({menu_.IsOpen(now) ? 1U : 0U}, now, board::SourceState::kLive);
}

// By what their programs write at least four times a second while somebody is at it.
bool InstallService::IsBusyElsewhere(Time now) const {
  const auto is_fresh = [now](const auto& section) {
    return section.source == board::SourceState::kLive && now - section.at < kSilence;
  };
  const auto check = board_.Read<board::LineCheck>();
  const auto learn = board_.Read<board::Learn>();
  return (is_fresh(check) && check.value.phase == board::LineCheckPhase::kRunning) ||
         (is_fresh(learn) && learn.value.phase != board::LearnPhase::kEnded) ||
         is_fresh(board_.Read<board::LipsGuide>());
}

// The stick may go while its show is checked; while it is copied, the copy itself notices. What is said of a
// stick goes with it, also where it could not be read any more before it was seen to be out.
void InstallService::Look(Time now) {
  look_next_ = now + kLookPeriod;
  FollowChosen();
  if (!std::exchange(has_looked_, true)) OfferBefore();
  auto looked = look_();
  const bool is_busy = IsBusy();
  if (!looked && !is_busy) TellOfStick(Message::kUnreadable, looked.error().message());
  auto stick = looked.value_or(std::nullopt);
  const bool is_another = stick != stick_, is_out = looked && !stick;
  stick_ = std::move(stick);
  if (is_busy) return;
  if (is_another) DropQuestion();
  if (is_another && stick_) return OfferAll(*stick_, now);
  if (is_another) OfferBefore();
  if (is_out && said_ && said_->of_stick) Tell(Message::kPlugIn);
  if (is_out && !said_ && !menu_.empty()) Tell(Message::kShut);
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

void InstallService::OfferAll(const std::filesystem::path& stick, Time now) {
  const auto listed = List(stick);
  if (!listed) {
    OfferBefore();
    return TellOfStick(Message::kPulled, listed.error().message());
  }
  menu_.Open(now);
  is_open_ = menu_.IsOpen(now);
  TellOfStick(*listed == 0 ? Message::kNoShow : Message::kChoose);
}

Result<std::size_t> InstallService::List(const std::filesystem::path& stick) {
  ExpectSlowDisk();
  std::vector<Choosable> below = WaysBackOnBox(true);
  if (of_box_.support)
    below.push_back({.kind = Choosable::Kind::kSupport,
                     .offer = {.file = {}, .name = "support file for a technician, onto the stick"},
                     .remark = {}});
  auto offered = OffersOf(stick, below);
  if (!offered) return tl::unexpected(offered.error());
  menu_.Offer(std::move(offered->choices), offered->left_out);
  return offered->of_stick;
}

// The list is shut: who pushes GO to try the show that has just come must not go back by it.
void InstallService::OfferBefore() {
  menu_.Offer(WaysBackOnBox(false));
  menu_.Shut();
  is_open_ = false;
  if (said_) Show();
}

void InstallService::ListAnew() {
  if (!stick_ || !List(*stick_)) OfferBefore();
}

void InstallService::Accept(const Choosable& taken) {
  if (taken.kind == Choosable::Kind::kShow) return Install(taken);
  if (taken.kind == Choosable::Kind::kKey) return AskForKey(taken);
  if (taken.kind == Choosable::Kind::kTrust || taken.kind == Choosable::Kind::kDistrust)
    return AnswerForKey(taken);
  if (taken.kind == Choosable::Kind::kBack) return GoBack(taken);
  if (taken.kind == Choosable::Kind::kUpdate || taken.kind == Choosable::Kind::kRestart)
    return CallUpdate(taken);
  if (of_box_.settings != nullptr && IsOfSettings(taken)) return AcceptSettings(taken);
  if (taken.kind != Choosable::Kind::kSupport) return AcceptCopy(taken);
  writes_support_ = true;
  Tell(Message::kWriting);
}

// What plays goes on, and nothing else of the stick is touched, however this ends.
void InstallService::WriteSupport() {
  writes_support_ = false;
  const Result<std::string> name =
      stick_ ? of_box_.support(*stick_) : Fail(std::errc::no_such_device, "write the support file");
  if (name)
    Tell(Message::kWritten, *name);
  else
    Tell(SupportMessageOf(name.error()), "support file", name.error().message());
  menu_.ForgetPresses();
}

// It was tried when it came. The stage passes over a pack that the disk has spoilt, and that is said then.
void InstallService::GoBack(const Choosable& taken) {
  name_ = taken.offer.name;
  const store::Choice choice = ReadChoice(folder_);
  if (auto ok = WriteChoice(folder_, {store::NextGeneration(choice, Told()), taken.id, choice.current}); !ok)
    return Tell(DiskMessageOf(ok.error()), name_, ok.error().message());
  TellStage();
  ListAnew();
  Tell(Message::kInstalled, name_);
}

// By a number in memory, so that the stage asks no disk while a show plays.
void InstallService::TellStage() {
  awaited_ = ReadChoice(folder_);
  frames_at_begin_.reset();
  WriteSaid(places_.report / kTold, std::to_string(awaited_->generation) + "\n");
}

std::uint64_t InstallService::Told() const {
  return store::ReadTold(places_.report / kTold);
}

// The name is kept: a stick that is gone can no longer be asked for it.
void InstallService::Install(const Choosable& taken) {
  name_ = taken.offer.name;
  awaited_.reset();
  auto source = OpenSource(taken.offer.file);
  if (!source) return Tell(MessageOf(source.error()), name_, source.error().message());
  installation_.emplace(folder_, std::move(*source), Keys(), trial_, OnBox{.plays = Plays(), .told = Told()});
  Tell(Message::kCopying, name_);
}

void InstallService::StepInstallation() {
  if (!MayWork()) return;
  const Message before = installation_->progress().message;
  const Progress progress = installation_->Step();
  if (installation_->ended()) ListAnew();
  if (progress.message != before || installation_->ended()) Tell(progress.message, name_, progress.detail);
  if (!installation_->ended()) return;
  if (progress.message == Message::kInstalled) TellStage();
  installation_.reset();
  menu_.ForgetPresses();  // Whoever pressed again while nothing seemed to happen takes nothing more.
}

}  // namespace kaori::shows
