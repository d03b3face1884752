// kaori-report: the show report of each evening, made by the box itself beside its show log.
//
// It lives as long as the box does, asks nothing of anybody, and works while the processors have nothing else to do.
#include <algorithm>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/board/service_key.h"
#include "appliance/core/board/show_now.h"
#include "appliance/programs/report/report_times.h"
#include "appliance/programs/report/reports.h"
#include "drivers/base/clock.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"

namespace {

constexpr std::string_view kHelp = R"(kaori-report: writes the show report of each evening beside its show log

  --logs FOLDER   the stage's show logs; reports are written there
  --pack FILE     the show of the box itself
  --shows FOLDER  other shows that may have been played
  --own FOLDER    expressions that were made on the box; they are copied before they are read
  --board FILE    the board, by which it is seen that the last cue was played or the service key turned on
  --once          makes the reports that are missing now, says which, and ends
)";

struct Settings {
  std::string logs, pack, shows, own, board = "/run/kaori/board";
  bool once = false;
};

constexpr auto kLook = std::chrono::seconds(1);

// Seconds for each evening on a machine that has time; the face may leave it next to none, and logs of a hundred evenings may
// have no report yet.
constexpr auto kLongestReports = std::chrono::minutes(30);

// A reason is logged once, however often it is found again.
void Make(const kaori::report::ReportPlaces& places, std::vector<std::string>& told) {
  kaori::ExpectLongCall(kLongestReports);
  const auto made = kaori::report::MakeReports(places);
  for (const auto& file : made.files) kaori::Log("the show report is written: {}", file.string());
  for (const std::string& fault : made.faults)
    if (std::find(told.begin(), told.end(), fault) == told.end())
      kaori::LogWarning("no show report: {}", fault);
  told = made.faults;
}

// A board that is not there, or was made anew in the meantime, is looked for each time.
kaori::report::EveningSigns SignsOn(const std::string& path) {
  const auto board = kaori::board::Board::Open(path);
  if (!board) return {};
  const auto show = board->Read<kaori::board::ShowNow>();
  return {.service_key = kaori::board::IsServiceKeyOn(board->Read<kaori::board::Lines>()),
          .list_over = show.source == kaori::board::SourceState::kLive && show.value.cue_count > 0 &&
                       show.value.cue_standby >= show.value.cue_count && show.value.cue_pending < 0};
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-report");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--logs", settings.logs)
      .Text("--pack", settings.pack)
      .Text("--shows", settings.shows)
      .Text("--own", settings.own)
      .Text("--board", settings.board)
      .Switch("--once", settings.once);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (settings.logs.empty())
    return kaori::ExitWithError(
        kaori::FailInput("--logs is missing: it says where the show logs are").value());
  kaori::report::ReportPlaces places{.logs = settings.logs, .own = settings.own, .packs = {}};
  for (const std::string* pack : {&settings.pack, &settings.shows})
    if (!pack->empty()) places.packs.emplace_back(*pack);
  std::vector<std::string> told;
  if (settings.once) {
    Make(places, told);
    return told.empty() ? 0 : 1;
  }
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  if (auto ok = kaori::service::FeedWatchdogOfUnit(*loop); !ok) return kaori::ExitWithError(ok.error());
  const kaori::SteadyClock clock;
  kaori::report::ReportTimes times(clock.now());
  const auto ran = loop->RunEvery(kLook, [&] {
    if (times.IsDue(clock.now(), SignsOn(settings.board))) Make(places, told);
  });
  if (!ran) return kaori::ExitWithError(ran.error());
  return 0;
}
