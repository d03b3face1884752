#include "appliance/programs/update/confirm.h"

#include <chrono>
#include <system_error>
#include <utility>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/update/kernel_log.h"
#include "appliance/programs/update/looking.h"
#include "appliance/programs/update/looks.h"
#include "appliance/programs/update/restart.h"
#include "appliance/programs/update/running.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/program.h"
#include "drivers/base/read_file.h"
#include "drivers/base/run_program.h"
#include "drivers/base/whole_file.h"

namespace kaori::update {
namespace {

namespace fs = std::filesystem;
using Verdict = Confirmation::Verdict;

constexpr std::size_t kMostPicture_bytes = std::size_t{8} << 20U;
constexpr std::size_t kMostJournal_bytes = std::size_t{64} << 10U;
constexpr auto kLookPeriod = std::chrono::seconds(5);
constexpr auto kLongestAnswer = std::chrono::seconds(20);
// Without one of these a box that is operated would not answer its operators.
const std::vector<std::string> kPrograms{"kaori-stage.service", "kaori-input.service", "kaori-lips.service"};

std::string PictureOf(const std::string& file) {
  return ReadFile(file, {.most_bytes = kMostPicture_bytes}).value_or("");
}

// A board that is not there says what one says that no stage has written.
Time NewestFlip(const std::string& board) {
  const auto opened = board::Board::Open(board);
  return opened ? opened->Read<board::StageStatus>().value.flipped_at : Time{};
}

fs::path LookFile(const TrialPlaces& places) {
  return fs::path(places.said) / "looking";
}

// A file in memory, by its name alone. Where it cannot be written that is one line in the log.
void Mark(const TrialPlaces& places, const char* name) {
  if (auto told = WriteWholeFile(fs::path(places.said) / name, {}); !told)
    LogWarning("{}", told.error().message());
}

// Everything that is looked at, from one look to the next.
class Looks {
 public:
  Looks(const TrialPlaces& places, Restarts restarts)
      : places_(places), restarts_(restarts), last_(PictureOf(places.last_face)) {}

  // Looks at everything once, the cheapest first: what is found becomes the reason where the system gives way.
  Reason FaultNow(Time now) {
    std::vector<std::string> ask{places_.systemctl, "show", "--property=Id,ActiveState,NRestarts"};
    ask.insert(ask.end(), kPrograms.begin(), kPrograms.end());
    const auto programs = OutputOf(ask, kMostJournal_bytes, kLongestAnswer);
    if (!programs) return {programs.error().message(), "プログラムの状態を調べられません"};
    if (auto fault = ProgramsFault(*programs, kPrograms.size(), restarts_); !fault.empty()) return fault;
    const auto log = ReadKernelLog();
    if (!log) return {log.error().message(), "カーネルのログを読めません"};
    if (auto fault = DiskFault(*log); !fault.empty()) return fault;
    if (auto fault = frames_.Fault(NewestFlip(places_.board), now); !fault.empty()) return fault;
    std::error_code none;
    const auto made = fs::last_write_time(places_.picture, none);
    if (none || std::exchange(made_, made) == made)
      return {"the stage shows no new picture", "ステージが新しい画面を出しません"};
    const std::string still = PictureOf(places_.still);
    return PictureFault(PictureOf(places_.picture), {still, last_});
  }

 private:
  const TrialPlaces& places_;
  Restarts restarts_;
  // The last face that the system before has kept: a stage keeps none while it is tried, since that would speak for itself.
  std::string last_;
  ShownFrames frames_;
  // When the picture of the look before was made: a stage that hangs makes no new one.
  fs::file_time_type made_{};
};

// The exit status: another than 0 where the restart was refused.
int Restart(const TrialPlaces& places, Stop stop) {
  const auto told = RestartMachine(places.systemctl, stop);
  return told ? 0 : ExitWithError(told.error());
}

// Keeps the reason and starts the system before.
int BackWith(const TrialPlaces& places, Notes& notes, const Reason& reason) {
  const auto log = OutputOf({"/bin/journalctl", "-b", "--no-pager", "-o", "short-monotonic"},
                            kMostJournal_bytes, kLongestAnswer);
  ExpectSlowDisk();
  if (auto kept = GiveWay(notes, reason, log.value_or("")); !kept) LogWarning("{}", kept.error().message());
  LogError("this version gives way to the one before: {}", reason.english);
  return Restart(places, Stop::kInOrder);
}

// One that does well and cannot be kept gives way too: at the next start it would be the one before all the same, without a reason.
int End(const TrialPlaces& places, Verdict verdict, const Reason& reason, ports::BootChoice& choice,
        Notes& notes, std::uint32_t version) {
  if (verdict != Verdict::kStays) return BackWith(places, notes, reason);
  if (const auto stays = ConfirmTried(choice, notes); !stays)
    return BackWith(places, notes, {stays.error().message(), "起動の設定を書けません"});
  Mark(places, "settled");
  TellStatus(places.said, {Message::kConfirmed, version});
  return 0;
}

// The stage makes pictures of what it draws as long as `wanted` is there.
int LookOn(const TrialPlaces& places, ports::BootChoice& choice, Notes& notes, std::uint32_t version,
           EventLoop& loop) {
  NoteStart(notes);
  const SteadyClock clock;
  Confirmation confirmation(clock.now());
  Looks looks(places, version == 0 ? Restarts::kAreNone : Restarts::kAreFaults);
  Mark(places, "wanted");
  int status = 0;
  const auto look = [&] {
    const auto verdict = confirmation.Observe(looks.FaultNow(clock.now()), clock.now());
    if (verdict == Verdict::kLooking) return;
    status = End(places, verdict, confirmation.reason(), choice, notes, version);
    loop.Stop();
  };
  const auto ran = loop.RunEvery(kLookPeriod, look);
  std::error_code none;
  fs::remove(fs::path(places.said) / "wanted", none);
  return ran ? status : ExitWithError(ran.error());
}

// Of a start that is, by its note, one of a try: whatever fails from here on is a look in vain. A note that outlived its confirmation
// is forgotten, and was none.
int ConfirmSlot(const TrialPlaces& places, ports::Slot running, bool is_tried, int in_vain, Notes& notes) {
  auto loop = EventLoop::Open();
  if (!loop) return ExitWithError(loop.error());
  if (auto ok = service::FeedWatchdogOfUnit(*loop); !ok) return ExitWithError(ok.error());
  const auto choice = places.open_choice(running);
  if (!choice) return ExitWithError(choice.error());
  const auto found = AfterStart(**choice, notes);
  if (found.message != Message::kNothingWaits) TellStatus(places.said, found);
  if (found.message == Message::kOtherLayout && is_tried) return 1;
  if (found.message != Message::kLooking) {
    EndLook(LookFile(places));
    Mark(places, "settled");
    return 0;
  }
  if (in_vain == 0) return LookOn(places, **choice, notes, found.version, *loop);
  return BackWith(places, notes, VainLook());
}

}  // namespace

void TellStatus(const fs::path& said, const Outcome& outcome) {
  const std::string text = Say(outcome.message, Language::kEnglish, outcome.version, outcome.detail) + "\n" +
                           Say(outcome.message, Language::kJapanese, outcome.version, outcome.japanese) +
                           "\n";
  LogWarning("{}", text.substr(0, text.find('\n')));
  if (auto told = WriteWholeFile(said / "notice", {AsBytes(text)}); !told)
    LogWarning("{}", told.error().message());
}

// A look that hung is never made again: nobody could say when it ends.
int Confirm(const TrialPlaces& places) {
  const int in_vain = LooksInVain(LookFile(places));
  if (in_vain > 1) return Restart(places, Stop::kAtOnce);
  const auto running = ReadSlot(places.slot);
  if (!running) return ExitWithError(running.error());
  const auto notes = OpenNotes(places.notes);
  const auto pending = notes->ReadPending();
  const bool is_tried = pending && pending->slot == *running;
  if (is_tried && in_vain == 0) BeginLook(LookFile(places));
  return ConfirmSlot(places, *running, is_tried, in_vain, *notes);
}

}  // namespace kaori::update
