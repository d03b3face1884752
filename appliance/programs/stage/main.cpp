// kaori-stage: draws the face that the board describes.
//
// One loop draws everything. Besides it are Mesa's threads, one that loads the show at the start, and five that write the last face,
// the journal of the needles, the list of screens, the show log, and what is taught; the frame path waits for none of them.
//
// The service manager is told READY=1 once the first picture is drawn, or there is no screen to draw it for. It watches the steps
// of the start until then (service::StartWatch), and from then on the loop (service::Watchdog). A stage that is killed at any
// moment is started anew and goes on from the state on the board, while the fd keeper keeps the last picture on the screen. It
// ends with status 1 where the show, the board, GL or the card cannot be had, and with 2 where it is misused; a screen that is
// missing never ends it.
#include <ctime>
#include <future>
#include <optional>

#include "appliance/core/board/watch.h"
#include "appliance/core/show/pack.h"
#include "appliance/programs/editor/expression_editor.h"
#include "appliance/programs/stage/chosen_show.h"
#include "appliance/programs/stage/evening.h"
#include "appliance/programs/stage/last_face.h"
#include "appliance/programs/stage/loading.h"
#include "appliance/programs/stage/quality_choice.h"
#include "appliance/programs/stage/rehearsal.h"
#include "appliance/programs/stage/screen_session.h"
#include "appliance/programs/stage/show_log.h"
#include "appliance/programs/stage/stage.h"
#include "appliance/programs/stage/stage_monitor.h"
#include "appliance/programs/stage/stage_options.h"
#include "appliance/programs/stage/stage_status_display.h"
#include "appliance/programs/stage/still.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/alarm.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/folder.h"
#include "drivers/base/graphics_cards.h"
#include "drivers/base/log.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/program.h"
#include "drivers/base/service.h"
#include "drivers/base/start_watch.h"
#include "drivers/scanout/kms_card.h"
#include "drivers/scanout/kms_mode.h"
#include "drivers/scanout/local_screen.h"

namespace {

// The width of the small picture that is kept beside the last face.
constexpr int kStillWidth_px = 480;

using Settings = kaori::stage::StageOptions;

// The graphics card of a box. Null on a desk, where the simulator's screen is looked for, and in a box that
// has none: playing unseen keeps the lamps alive. Any other failure ends the program, and systemd starts it
// again.
kaori::Result<std::unique_ptr<kaori::scanout::KmsCard>> CardOf(const Settings& settings) {
  if (settings.card.empty()) return nullptr;
  const std::string file = kaori::CardFile(settings.card);
  if (file.empty()) {
    kaori::LogWarning("there is no graphics card with a socket for a screen: playing on unseen");
    return nullptr;
  }
  auto card = kaori::scanout::KmsCard::Open(file, settings.fdkeeper);
  if (!card && card.error().cause == std::errc::no_such_file_or_directory) {
    kaori::LogWarning("there is no graphics card ({}): playing on unseen", card.error().message());
    return nullptr;
  }
  if (!card) return card;
  auto facts = kaori::status::ReadFacts({.settings = settings.settings});
  (*card)->SetPreferences({.mode = kaori::scanout::ParseMode(settings.mode),
                           .status_connector = std::move(facts.screen),
                           .monitor_connector = std::move(facts.monitor)});
  return card;
}

using Screen = std::unique_ptr<kaori::ports::Scanout>;

kaori::Result<Screen> OpenScreen(kaori::scanout::KmsCard& card, const kaori::Clock& clock) {
  auto screen = card.OpenScreen(clock);
  if (!screen) return tl::unexpected(screen.error());
  kaori::Log("{}", kaori::scanout::Describe((*screen)->wall()));
  return std::move(*screen);
}

// A card that comes later wants another start: what draws was chosen without it. The service manager then
// starts the stage anew, and the fade goes on where it was.
kaori::Result<Screen> AwaitCard(const std::string& told, kaori::EventLoop& loop) {
  if (kaori::IsThere(kaori::CardFile(told))) loop.Stop();
  return kaori::Fail(std::errc::no_such_device, "find a graphics card");
}

// Opens the stage's screen, again and again. `card` is null where there is none. Borrows all else for as long as it is called.
std::function<kaori::Result<Screen>()> ScreenOpener(const Settings& settings, kaori::scanout::KmsCard* card,
                                                    const kaori::Clock& clock, kaori::EventLoop& loop,
                                                    kaori::stage::QualityForScreens& sizes) {
  return [&settings, card, &clock, &loop, &sizes]() -> kaori::Result<Screen> {
    auto screen = settings.card.empty() ? kaori::scanout::LocalScreen::Open(settings.links)
                  : card != nullptr     ? OpenScreen(*card, clock)
                                        : AwaitCard(settings.card, loop);
    if (screen) sizes.See(**screen);
    return screen;
  };
}

// None where nobody says where, or where the disk refuses: an evening without a log is played.
std::unique_ptr<kaori::stage::ShowLog> LogOf(const Settings& settings, const kaori::showlog::LogHead& head) {
  if (settings.log.empty()) return nullptr;
  auto log = kaori::stage::ShowLog::Open(settings.log, head);
  if (log) return std::move(*log);
  kaori::LogWarning("this evening has no show log: {}", log.error().message());
  return nullptr;
}

// None where nobody says where; else what was kept there before is taken up.
std::unique_ptr<kaori::stage::LastFace> LastFaceOf(
    const Settings& settings, const std::filesystem::path& pack, kaori::stage::Studio& studio,
    const kaori::board::Board& board, kaori::stage::StageWriters& writers, const kaori::Clock& clock) {
  if (settings.last_face.empty()) return nullptr;
  const kaori::stage::LastFaceFile where{settings.last_face, kaori::stage::ShowMark(pack).value_or(0)};
  const auto taken_up =
      kaori::stage::ResumeLastFace(where, studio.show(), board, writers.performance, clock.now());
  const auto look = [&studio](kaori::stage::SmallImage& into) {
    return studio.ReadSmall(kStillWidth_px, into);
  };
  const auto is_on_trial = [&settings] {
    std::error_code none;
    return std::filesystem::exists(settings.trial, none) && !std::filesystem::exists(settings.settled, none);
  };
  return std::make_unique<kaori::stage::LastFace>(where, look, is_on_trial, taken_up);
}

// What a stage is made of, before anything is drawn.
struct Prepared {
  std::unique_ptr<kaori::scanout::KmsCard> card;  // Null: as CardOf says.
  std::unique_ptr<kaori::gl::Context> context;
  kaori::stage::Loaded show;
};

// The show is loaded on another thread beside Mesa, which takes about as long; all else is this thread's.
// It is the first step of the start.
kaori::Result<Prepared> Prepare(const Settings& settings, const kaori::stage::ShowPlaces& places,
                                kaori::service::StartWatch& start) {
  std::optional<kaori::Result<kaori::stage::Loaded>> loaded;  // GCC 12 warns where a future carries it.
  auto loading =
      std::async(std::launch::async, [&] { loaded.emplace(kaori::stage::LoadShow(settings, places)); });
  auto card = CardOf(settings);
  if (card && *card) kaori::Log("the graphics card is open");
  auto context = card.and_then(
      [](const auto& each) { return kaori::gl::Context::Open(each ? each->device() : nullptr); });
  loading.get();
  if (!*loaded) return tl::unexpected(loaded->error());
  if (!context) {
    kaori::stage::NoteOrderlyEnd(places);  // Another show would not find a card either.
    return tl::unexpected(context.error());
  }
  start.Step();
  return Prepared{std::move(*card), std::move(*context), std::move(**loaded)};
}

// Once the first picture is shown: it stays from now on, whatever ends the stage, and the service manager
// watches the loop. `card` is null where there is none. Errors: those of the watchdog's timer.
kaori::Result<void> BecomeReady(kaori::scanout::KmsCard* card, const kaori::stage::Stage& stage,
                                kaori::service::StartWatch& start, kaori::EventLoop& loop) {
  start.Step();
  if (card != nullptr)
    if (auto held = card->Preserve(); !held)
      kaori::LogWarning("the last picture will not stay when the stage ends ({})", held.error().message());
  start.Ready();
  return kaori::service::FeedWatchdog(loop, [&stage] { return stage.usual_turn(); });
}

// The displays beside the show, for technicians and for operators.
struct Beside {
  kaori::stage::StageStatusDisplay& status;
  kaori::stage::StageMonitor& monitor;
};

// Plays until somebody ends the loop, or another show is chosen; says the status and draws the operators'
// monitor meanwhile. Errors: those of the loop.
kaori::Result<void> PlayOn(kaori::stage::Stage& stage, kaori::board::Board& board, const Beside& beside,
                           kaori::stage::ShowWatch watch, const kaori::Clock& clock, kaori::EventLoop& loop) {
  const auto draw_monitor = [&] {
    auto* const screen = stage.screen();
    const bool has = screen != nullptr && !beside.status.on_monitor();
    beside.monitor.Step(has ? screen->monitor_display() : nullptr, {stage.state(), stage.wakes_at()});
  };
  if (auto ok = loop.Every(kaori::stage::StageMonitor::kPeriod, draw_monitor); !ok) return ok;
  const auto tell = [&] {
    beside.status.Step(stage.screen());
    stage.SetNotice(beside.status.notice());
    const bool over = watch.IsOver(clock.now());
    if (over) kaori::Log("another show is chosen: the stage ends, to be started with it");
    if (over || stage.taught() != nullptr) loop.Stop();
  };
  if (auto ok = loop.Every(kaori::stage::StageStatusDisplay::kPeriod, tell); !ok) return ok;
  if (auto ok = kaori::board::Watch(board, loop); !ok) return ok;
  return loop.Run();
}

// What a stage needs before its first step, of what was loaded; all of it is the stage's from here on.
void Furnish(kaori::stage::Stage& stage, kaori::stage::Loaded& loaded, kaori::stage::LoggedEvening& evening) {
  stage.SetEditor(std::move(loaded.editor));
  stage.LetTeach(std::move(loaded.own_roles));
  stage.SetLocalTime([] { return kaori::stage::WeekMinute(std::time(nullptr)); });
  if (evening.play) stage.PlayOver(std::move(evening.play));
}

// The writers are acquired before the show is loaded, so that a second stage ends at once and notes no show.
// Once the first picture is shown the card is handed to the fd keeper, so that the picture stays when the
// stage ends in whatever way. The last face is kept when the loop has ended.
int Play(const Settings& settings, kaori::service::StartWatch& start, kaori::EventLoop& loop) {
  auto board = kaori::board::Board::Create(settings.board);
  if (!board) return kaori::ExitWithError(board.error());
  auto writers = kaori::stage::StageWriters::Acquire(*board);
  if (!writers) return kaori::ExitWithError(writers.error());
  const auto places = kaori::stage::PlacesOf(settings);
  if (!places) return kaori::ExitWithError(places.error());
  auto prepared = Prepare(settings, *places, start);
  if (!prepared) return kaori::ExitWithError(prepared.error());
  auto& [card, context, loaded] = *prepared;
  const auto studio = kaori::stage::Studio::Open(std::move(loaded.show), std::move(context));
  if (!studio) return kaori::ExitWithError(studio.error());
  start.Step();
  const auto quality = kaori::stage::ChooseQuality(**studio, settings.quality);
  kaori::stage::StillClock clock(!settings.still.empty());
  auto evening = kaori::stage::OpenEvening(
      settings.evening, loaded.pack, kaori::stage::OwnFolder(settings) / "roles.toml", (*studio)->show());
  if (!evening) return kaori::ExitWithError(evening.error());
  if (loaded.another)  // What lies on the board is the state of the show before.
    writers->performance.Write({}, clock.now(), kaori::board::SourceState::kAbsent);
  auto last_face = LastFaceOf(settings, loaded.pack, **studio, *board, *writers, clock);
  kaori::stage::Stage stage(*board, std::move(*writers), **studio, clock);
  Furnish(stage, loaded, *evening);
  const auto log = LogOf(settings, loaded.log_head);
  if (log) stage.SetLog(&log->recorder());
  if (last_face)
    stage.CallAfterFrames(
        [&](const auto& state, const auto& scene, auto now) { last_face->Observe(state, scene, now); });
  kaori::Log("{} is {} on {}; quality {}", (*studio)->show().name, stage.resumed() ? "resumed" : "opened",
             (*studio)->renderer(), quality);
  start.Step();
  auto alarm = kaori::Alarm::Make();
  if (!alarm) return kaori::ExitWithError(alarm.error());
  if (!settings.early) stage.SampleLate();
  kaori::stage::QualityForScreens sizes(**studio, settings.quality);
  kaori::stage::ScreenSession session(stage, loop, std::move(*alarm),
                                      ScreenOpener(settings, card.get(), clock, loop, sizes));
  if (auto begun = session.Begin(); !begun) return kaori::ExitWithError(begun.error());
  kaori::Log("the first picture is drawn");
  clock.LetGo();
  if (auto ok = WriteStills(**studio, kaori::stage::StillFilesOf(settings), loop); !ok)
    return kaori::ExitWithError(ok.error());
  if (auto ok = BecomeReady(card.get(), stage, start, loop); !ok) return kaori::ExitWithError(ok.error());
  const kaori::status::Places said{settings.settings,
                                   std::filesystem::path(settings.board).parent_path() / "screens"};
  kaori::stage::StageStatusDisplay status(*board, clock, said);
  kaori::stage::StageMonitor monitor(*board, clock, **studio, status, [] { return std::time(nullptr); });
  const auto played =
      PlayOn(stage, *board, {status, monitor}, {*places, loaded.generation, clock.now()}, clock, loop);
  // What is kept now goes to a disk that may be slow, and nothing beats any more.
  static_cast<void>(kaori::service::AllowSilence(std::chrono::seconds(10)));
  if (const auto* roles = stage.taught()) stage.HandOver(*roles);
  if (last_face) last_face->KeepNow();
  if (log) log->Finish();
  if (played) kaori::stage::NoteOrderlyEnd(*places);
  return played ? 0 : kaori::ExitWithError(played.error());
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-stage");
  Settings settings;
  if (const auto status = kaori::stage::ParseOptions(argc, argv, settings)) return *status;
  if (!settings.rehearse.empty()) {
    const auto plays = kaori::show::LoadPack(settings.rehearse).and_then(kaori::stage::Rehearse);
    return plays ? 0 : kaori::ExitWithError(plays.error());
  }
  if (!settings.mode.empty() && !kaori::scanout::ParseMode(settings.mode)) {
    kaori::LogError("--mode {}: expected width, height and rate, as in 1280x720@50", settings.mode);
    return 2;
  }
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  const kaori::SteadyClock clock;
  kaori::service::StartWatch start(clock, settings.board + "-starts");
  return Play(settings, start, *loop);
}
