// kaori-data: mends the data partition, once the service key is on; and hears who asks for a factory reset.
//
// It mends only on a box whose data partition could not be mounted: kaori-boot leaves its device's name in a
// file. The show plays meanwhile, and keeps nothing. Nobody's settings are touched before somebody with the
// key wants it.
#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>

#include "appliance/core/board/service_key.h"
#include "appliance/programs/data/folders.h"
#include "appliance/programs/data/mend.h"
#include "appliance/programs/data/reset_request.h"
#include "drivers/base/clock.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/base/read_file.h"
#include "drivers/base/run_program.h"
#include "drivers/base/whole_file.h"

namespace {

using kaori::Result;

constexpr std::string_view kHelp =
    R"(kaori-data: mends the data partition of a box, once the service key is on

  --board FILE      the board, shared with the other programs (/run/kaori/board)
  --settings FOLDER what kaori-boot left when the box started (/run/kaori-profile)
  --reset FILE      instead: makes this file, by which the next start is a factory reset, and starts the box again, where
                    GO is held for 10 s with the service key on in the first minute, and let go
  --notice FILE     what the status picture says of that (/run/kaori-reset/notice)

What e2fsck can save is saved. A partition that is beyond mending is made anew, and what it kept is lost.
)";

struct Settings {
  std::string board = "/run/kaori/board", folder = "/run/kaori-profile", reset,
              notice = "/run/kaori-reset/notice";
};

constexpr auto kPeriod = std::chrono::milliseconds(100);
// A key that is turned, and not one that chatters or a line that is plugged in.
constexpr auto kHeld = std::chrono::seconds(2);
constexpr unsigned kReadOnly = 0444;
constexpr const char* kFolders = "/run/kaori-data/folders";

// Blocks until the key has been on for kHeld. Errors: those of the loop.
Result<void> AwaitKey(const std::string& board) {
  auto loop = kaori::EventLoop::Open();
  if (!loop) return tl::unexpected(loop.error());
  if (auto ok = kaori::service::FeedWatchdogOfUnit(*loop); !ok) return ok;
  const kaori::SteadyClock clock;
  kaori::Time off = clock.now();
  return loop->RunEvery(kPeriod, [&] {
    if (!kaori::board::IsServiceKeyOnAt(board)) off = clock.now();
    if (clock.now() - off >= kHeld) loop->Stop();
  });
}

// What the status picture says, in both languages.
constexpr const char* kLetGo =
    "Let go of GO now: the box forgets its shows and settings and starts again. Hold it on to change "
    "nothing.\n"
    "今GOを離すと、公演と設定を消して再起動します。押し続けると何も変わりません。\n";
constexpr const char* kResets =
    "The box forgets its shows and settings and starts again.\n"
    "公演と設定を消して再起動します。\n";

// An empty text takes the notice away. Without it the reset is done all the same.
void SayOfReset(const std::string& file, std::string_view text) {
  std::error_code none;
  if (text.empty())
    std::filesystem::remove(file, none);
  else if (auto told = kaori::WriteWholeFile(file, {kaori::AsBytes(text)}, kReadOnly); !told)
    kaori::LogWarning("{}", told.error().message());
}

// Blocks until it is known whether somebody asks. Errors: those of the loop.
Result<bool> AwaitRequest(const Settings& settings) {
  using Verdict = kaori::data::ResetRequest::Verdict;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return tl::unexpected(loop.error());
  if (auto ok = kaori::service::FeedWatchdogOfUnit(*loop); !ok) return tl::unexpected(ok.error());
  const kaori::SteadyClock clock;
  kaori::data::ResetRequest request(clock.now());
  auto verdict = Verdict::kWaiting;
  const auto look = [&] {
    const auto board = kaori::board::Board::Open(settings.board);
    const auto lines =
        board ? board->Read<kaori::board::Lines>() : kaori::board::Stamped<kaori::board::Lines>{};
    const bool key_is_on = IsServiceKeyOn(lines);
    const auto before = verdict;
    verdict = request.See(key_is_on, key_is_on && IsOn(lines.value, kaori::board::Line::kGo), clock.now());
    if (verdict != before) SayOfReset(settings.notice, verdict == Verdict::kLetGo ? kLetGo : "");
    if (verdict == Verdict::kAsked || verdict == Verdict::kOver) loop->Stop();
  };
  if (auto ran = loop->RunEvery(kPeriod, look); !ran) return tl::unexpected(ran.error());
  return verdict == Verdict::kAsked;
}

// Whoever asks has both in their hands for as long as it takes to think again, and reads what happens as they let go.
// The next start does it, before any other program (kaori-boot).
Result<void> ResetWhereAsked(const Settings& settings) {
  const auto asked = AwaitRequest(settings);
  if (!asked) return tl::unexpected(asked.error());
  if (!*asked) return {};
  kaori::ExpectSlowDisk();
  if (auto kept = kaori::WriteWholeFile(settings.reset, {}); !kept) return kept;
  kaori::LogWarning("GO was held with the service key on: the box starts again, and what it kept goes");
  SayOfReset(settings.notice, kResets);
  kaori::ExpectLongCall();
  const auto status = kaori::RunProgram({"/bin/systemctl", "reboot"});
  if (!status) return tl::unexpected(status.error());
  return *status == 0 ? Result<void>{} : kaori::Fail(std::errc::io_error, "systemctl reboot");
}

// The programs that keep something find the partition when they start. The last picture stays meanwhile.
void RestartKeepers() {
  kaori::ExpectSlowDisk();
  for (const char* unit : {"kaori-stage.service", "kaori-lips.service", "kaori-journal.service"})
    if (const auto status = kaori::RunProgram({"/bin/systemctl", "restart", "--no-block", unit}); !status)
      kaori::LogWarning("{}", status.error().message());
}

// By the kernel's list, in which a device stands at the beginning of its line.
bool IsMounted(const std::string& device) {
  const std::string mounts = "\n" + kaori::ReadFile("/proc/self/mounts").value_or("");
  return mounts.find("\n" + device + " ") != std::string::npos;
}

// e2fsck reads each table of the partition, three times at most, from what may be a slow card; a disk that fails takes
// seconds for each block.
constexpr auto kLongestMending = std::chrono::hours(1);

// The file is removed last, and says until then that the mending is not done.
Result<void> MendWhatIsNamedIn(const Settings& settings, const std::string& file) {
  const auto device = kaori::ReadFile(file);
  if (!device) return tl::unexpected(device.error());
  // systemd's own try came later than that of the first program, and succeeded.
  if (IsMounted(*device)) {
    kaori::Log("{} is mounted: there is nothing to mend", *device);
    std::filesystem::remove(file);
    return {};
  }
  kaori::Log("the service key is on: {} is mended", *device);
  if (auto made = kaori::data::MakeFolders(kFolders); !made) return made;
  // By it systemd's mount unit knew that it must not mount what has errors.
  std::error_code none;
  std::filesystem::remove(settings.folder + "/data_errors", none);
  kaori::ExpectLongCall(kLongestMending);
  const auto mended = kaori::data::Mend({.device = *device, .folders = kFolders, .run = kaori::RunProgram});
  if (!mended) return tl::unexpected(mended.error());
  const std::string faults = settings.folder + "/faults";
  const std::string after = kaori::data::FaultsAfter(kaori::ReadFile(faults).value_or(""), *mended);
  kaori::LogWarning("{}", after);
  if (auto told = kaori::WriteWholeFile(faults, {kaori::AsBytes(after)}, kReadOnly); !told) return told;
  RestartKeepers();
  std::error_code failed;
  std::filesystem::remove(file, failed);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-data");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board)
      .Text("--settings", settings.folder)
      .Text("--reset", settings.reset)
      .Text("--notice", settings.notice);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (!settings.reset.empty()) {
    const auto done = ResetWhereAsked(settings);
    return done ? 0 : kaori::ExitWithError(done.error());
  }
  const std::string file = settings.folder + "/data_ruined";
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return kaori::Log("the data partition is whole"), 0;
  if (auto held = AwaitKey(settings.board); !held) return kaori::ExitWithError(held.error());
  if (auto mended = MendWhatIsNamedIn(settings, file); !mended) return kaori::ExitWithError(mended.error());
  return 0;
}
