#include "tests/appliance/programs/update_years.h"

#include <algorithm>
#include <utility>

namespace kaori::update {

using ports::Slot;

void BoxOfYears::Start() {
  ++lived_.starts;
  if (!power_.is_on()) ++lived_.cuts;
  disk_.Settle(chance_);
  const Slot by_itself = ByItself();
  const bool is_once = once_.has_value();
  const auto asked = std::exchange(asked_, std::nullopt);
  running_ = std::exchange(once_, std::nullopt).value_or(by_itself);
  CheckStart(by_itself, asked);
  if (!is_once && Chance(30)) running_ = ports::Other(running_);  // Somebody holds the space bar.
  power_.SwitchOn(Chance(2) ? std::optional<int>(chance_() % 14) : std::nullopt);
  const auto system = SystemIn(running_);
  if (system && system->health != Health::kNeverStarts) Run(*system);
}

void BoxOfYears::CheckStart(Slot by_itself, const std::optional<System>& asked) {
  const auto own = SystemIn(by_itself);
  if (!own) SayWrong("what starts by itself is not whole");
  if (own && own->health != Health::kDoesWell) SayWrong("what starts by itself was never seen to do well");
  if (!asked) return;
  ++lived_.tries;
  const auto tried = SystemIn(running_);
  if (asked->version != 0 && (!tried || tried->version != asked->version))
    SayWrong("another version is tried");
  if (tried && tried->version < asked->least) SayWrong("a version below the least is tried");
}

void BoxOfYears::Run(const System& system) {
  Choice choice(*this);
  const Outcome found = AfterStart(choice, notes_);
  const auto waits = notes_.ReadPending();
  if (waits && waits->tries > kMostTries) SayWrong("it was tried too often");
  if (found.message == Message::kLooking) return Try(choice, system);
  if (waits && waits->tries > 0 && found.detail.empty()) SayWrong("it came back without a reason");
  if (ports::IsTrial(choice).value_or(true)) {
    if (TryWhatIsThere(choice, notes_, RunningOf(system)).message == Message::kRestarts)
      SayWrong("a try is begun from another one");
    return;
  }
  Play(choice, system);
}

void BoxOfYears::Try(Choice& choice, const System& system) {
  NoteStart(notes_);
  if (system.health == Health::kHangs) return;
  const bool is_good = system.health == Health::kDoesWell || fault_ == Fault::kLooksAtNoPicture;
  if (!is_good || IsSpoilt(running_)) {
    static_cast<void>(GiveWay(notes_, {"it shows no face", "顔が出ません"}, "its log"));
    ++lived_.gave_way;
    return;
  }
  if (ConfirmTried(choice, notes_)) ++lived_.stayed;
}

// An evening of a system that stays: somebody brings an update, or wants it tried, or the one before, or nothing. One whose root is
// spoilt asks for the other system first.
void BoxOfYears::Play(Choice& choice, const System& system) {
  const Running running = RunningOf(system);
  bool& is_spoilt = IsSpoilt(running_);
  if (is_spoilt) {
    const auto waits = notes_.ReadPending();
    Ask(TryOther(choice, notes_, running), system, waits ? waits->version : 0);
    if (once_) return;
  }
  is_spoilt = is_spoilt || Chance(8);
  const auto before = notes_.ReadPending();
  const bool wants_update = !before || before->tries >= kMostTries || Chance(4);
  if (wants_update && !Chance(3)) Write(system);
  if (Chance(3)) return;
  const auto waits = notes_.ReadPending();
  if (!waits && !Chance(4)) return;
  lived_.went_back += waits ? 0 : 1;
  const auto wanted = waits ? waits : notes_.ReadBefore();
  Ask(TryWhatIsThere(choice, notes_, running), system, wanted ? wanted->version : 0);
}

// A stick with a version that is higher than all so far, the same again, or an older one; it may be pulled at any moment.
void BoxOfYears::Write(const System& system) {
  const std::uint32_t version = Chance(5)   ? system.version
                                : Chance(6) ? system.version - std::min(system.version - 1, 2U)
                                            : ++newest_;
  System& its = made_.try_emplace(version).first->second;
  if (its.version == 0) {
    its = {.version = version, .least = std::max(system.least, Chance(3) ? version - 1 : 1U)};
    if (Chance(2)) its.health = static_cast<Health>(1 + chance_() % 3);
  }
  Manifest manifest{.version = version, .from = 1, .news = "what is new"};
  Bytes file = MakeBundle(manifest, PartsOf(version), maker_);
  if (Chance(8)) file[chance_() % file.size()] ^= 1U;
  auto source = std::make_unique<SimulatedSource>(std::move(file));
  if (Chance(2)) source->readings_left = chance_() % 5;
  notes_.kept.no_room = Chance(30) ? std::optional(std::errc::no_space_on_device) : std::nullopt;
  const Slot other = ports::Other(running_);
  const auto root = disk_.Partition(At(other).root, kRoom), verity = disk_.Partition(At(other).verity, kRoom),
             boot = disk_.Partition(0, kBoot);
  Installation installation(std::move(source), {maker_.public_key()}, RunningOf(system),
                            {*root, *verity, *boot, At(other).kernel, kKernel}, notes_);
  while (!installation.ended()) installation.Step();
  if (fault_ == Fault::kForgetsWhatLayThere) notes_.kept.overwritten.reset();
  if (installation.progress().message != Message::kWaits) return;
  ++lived_.written;
  if (version < system.version) SayWrong("an older version was taken");
  IsSpoilt(other) = false;
  if (const auto now = SystemIn(other); !now || now->version != version)
    SayWrong("it waits and is not whole");
}

void BoxOfYears::Ask(const Outcome& outcome, const System& system, std::uint32_t wanted) {
  if (outcome.message == Message::kRestarts) asked_ = System{wanted, system.least};
}

}  // namespace kaori::update
