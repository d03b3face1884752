// kaori-input-latency: measures the latency from input to scan-out, with input sampled late and early, in one
// run. Runs on the box itself instead of the stage's unit; prints each round on one line.
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "appliance/core/board/board.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "tests/hil/latency/child.h"
#include "tests/hil/latency/simulated_dial.h"

namespace kaori::latency {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view kHelp = R"(kaori-input-latency: the latency from input to scan-out

  --mode MODE    the screen's, as in 320x180@4
  --loaded MODE  the screen's where a processor is kept busy; half as many events there (the same)
  --stage FILE   the program (/usr/bin/kaori-stage)
  --events N     of each round (70)
  --rounds N     of each arm (3)
  --board FILE   (/run/kaori/board)
  --pack FILE    the show
  --fdkeeper SOCKET  where the card is kept while no stage runs (/run/kaori-fdkeeper)
)";

constexpr int kLook_ms = 1;
constexpr Duration kLongest = 120s;  // For a stage to begin, and for input to be seen.
constexpr std::uint32_t kFirstFrames = 40, kMostFrames = 160;  // Before a round begins.
constexpr std::uint32_t kSettled = 6;                          // Of a period is then the margin.
constexpr std::uint32_t kAdapted = 30;                         // So many frames after a load step it is over.
constexpr std::uint32_t kStep = 100;  // Frames after a load step in which its end is looked for.

struct Settings {
  std::string stage = "/usr/bin/kaori-stage", mode = "320x180@4", loaded, events = "70", rounds = "3",
              board = "/run/kaori/board", fdkeeper = "/run/kaori-fdkeeper", pack;
};

struct Arm {
  const char* name;
  bool early;
  bool loaded;
};

// 4 where the text is no mode.
unsigned RateOf_hz(const std::string& mode) {
  constexpr int kUsual = 4, kMost = 1000;
  const auto at = mode.rfind('@');
  const int rate_hz = at == std::string::npos ? kUsual : std::atoi(mode.c_str() + at + 1);
  return unsigned(std::clamp(rate_hz, 1, kMost));
}

class LatencyBench {
 public:
  LatencyBench(const board::Board& board, SimulatedDial dial, const Settings& settings)
      : board_(board), dial_(std::move(dial)), settings_(settings) {}

  Result<void> Round(const Arm& arm, int round);

 private:
  board::StageStatus Status() const { return board_.Read<board::StageStatus>().value; }
  template <class Condition>
  bool Until(Condition condition);
  struct Seen {
    Duration waited{};  // From the device's report to the first flip of a frame that had read it.
    Duration shown{};   // Of that, from the reading to the flip.
  };
  Result<Seen> Event();
  void Note();
  unsigned Pause_ms(const std::string& mode);
  bool HasBegun(std::uint32_t frames, const std::string& mode) const;
  const std::string& ModeOf(const Arm& arm) const {
    return arm.loaded && !settings_.loaded.empty() ? settings_.loaded : settings_.mode;
  }

  const board::Board& board_;
  SimulatedDial dial_;
  const Settings& settings_;
  SteadyClock clock_;
  std::mt19937 random_{7};
  board::StageStatus step_;         // When the round's load began, or would have.
  std::uint32_t known_missed_ = 0;  // As far as Note has seen.
  std::uint32_t settled_ = 0;       // Frames from the step to the last flip that was missed for it.
};

// Whether it came true in time.
template <class Condition>
bool LatencyBench::Until(Condition condition) {
  for (const Time end = clock_.now() + kLongest; clock_.now() < end;) {
    dial_.Answer();
    Note();
    if (condition()) return true;
    ::poll(nullptr, 0, kLook_ms);
  }
  return false;
}

// Flips that are missed soon after the load began are missed for it.
void LatencyBench::Note() {
  const board::StageStatus now = Status();
  const std::uint32_t since = now.frames - step_.frames;
  if (now.missed_flips != std::exchange(known_missed_, now.missed_flips) && since <= kStep) settled_ = since;
}

// Up to one period of the screen: so input comes at any moment of a frame.
unsigned LatencyBench::Pause_ms(const std::string& mode) {
  return unsigned(random_() % (1000U / RateOf_hz(mode) + 1));
}

// The first frames compile shaders, and the margin that they widened needs some more to be what it usually
// is.
bool LatencyBench::HasBegun(std::uint32_t frames, const std::string& mode) const {
  const Duration widest = FromSeconds(1.0 / (RateOf_hz(mode) * kSettled));
  return frames >= kFirstFrames && (Status().margin < widest || frames >= kMostFrames);
}

Result<LatencyBench::Seen> LatencyBench::Event() {
  const auto at = dial_.Turn(clock_);
  if (!at) return tl::unexpected(at.error());
  if (!Until([&] { return board_.Read<board::Surface>().at >= *at; }))
    return Fail(std::errc::timed_out, "see the input on the board");
  const Time known = board_.Read<board::Surface>().at;
  board::StageStatus seen;
  if (!Until([&] { return (seen = Status()).sampled_at > known; }))
    return Fail(std::errc::timed_out, "see the input on the screen");
  return Seen{seen.flipped_at - *at, seen.flipped_at - seen.sampled_at};
}

double Milliseconds(Duration length) {
  return Seconds(length) * 1e3;
}

// At least one.
Duration Median(std::vector<Duration> lengths) {
  std::ranges::sort(lengths);
  return lengths[lengths.size() / 2];
}

std::string Describe(std::vector<Duration> waited) {
  std::ranges::sort(waited);
  const Duration sum = std::accumulate(waited.begin(), waited.end(), Duration());
  return fmt::format("events={} mean_ms={:.2f} least_ms={:.2f} median_ms={:.2f} p99_ms={:.2f}", waited.size(),
                     Milliseconds(sum) / double(waited.size()), Milliseconds(waited.front()),
                     Milliseconds(Median(waited)), Milliseconds(waited[waited.size() * 99 / 100]));
}

Result<void> LatencyBench::Round(const Arm& arm, int round) {
  std::vector<std::string> words{settings_.stage, "--board",    settings_.board,   "--pack",
                                 settings_.pack,  "--card",     "/dev/dri/card0",  "--mode",
                                 ModeOf(arm),     "--fdkeeper", settings_.fdkeeper};
  if (arm.early) words.emplace_back("--early");
  const std::uint32_t before = Status().frames;
  const auto stage = Child::Start(words);
  if (!stage) return tl::unexpected(stage.error());
  const auto has_begun = [&] { return HasBegun(Status().frames - before, ModeOf(arm)); };
  while (!Until([&] { return has_begun() || !stage->Runs(); }) && !has_begun()) Log("the stage is slow");
  if (!stage->Runs())
    return Fail(std::errc::no_child_process, "keep the stage playing, which " + stage->State());
  std::optional<Result<Child>> burner;
  if (arm.loaded) burner.emplace(Child::Burn());
  step_ = Status();
  known_missed_ = step_.missed_flips;
  settled_ = 0;
  if (arm.loaded && !Until([&] { return Status().frames - step_.frames >= kAdapted; }))
    return Fail(std::errc::timed_out, "keep the stage playing beside a busy processor");
  const board::StageStatus first = Status();
  std::vector<Duration> waited, shown;
  const auto wanted = std::size_t(std::atoi(settings_.events.c_str())) / (arm.loaded ? 2 : 1);
  while (waited.size() < wanted) {
    const auto event = Event();
    if (!event) return tl::unexpected(event.error());
    waited.push_back(event->waited);
    shown.push_back(event->shown);
    ::poll(nullptr, 0, int(Pause_ms(ModeOf(arm))));
  }
  const board::StageStatus last = Status();
  Log("round arm={} round={} {} read_to_flip_ms={:.2f} frames={} missed={} settled={} draw_ms={:.2f} "
      "margin_ms={:.2f}",
      arm.name, round, Describe(waited), Milliseconds(Median(shown)), last.frames - first.frames,
      last.missed_flips - first.missed_flips, settled_, Milliseconds(last.draw), Milliseconds(last.margin));
  return {};
}

Result<void> PlayAll(const Settings& settings) {
  const auto board = board::Board::Create(settings.board);
  if (!board) return tl::unexpected(board.error());
  auto dial = SimulatedDial::Open();
  if (!dial) return tl::unexpected(dial.error());
  LatencyBench bench(*board, std::move(*dial), settings);
  constexpr std::array kArms{Arm{"early", true, false}, Arm{"late", false, false},
                             Arm{"loaded", false, true}};
  for (int round = 0; round < std::atoi(settings.rounds.c_str()); ++round)
    for (const Arm& arm : kArms)
      if (auto played = bench.Round(arm, round); !played) return played;
  return {};
}

int Run(const Settings& settings) {
  if (const auto played = PlayAll(settings); !played)
    return LogError("not all rounds are played: {}", played.error().message()), 1;
  Log("all rounds are played");
  return 0;
}

}  // namespace
}  // namespace kaori::latency

int main(int argc, char** argv) {
  kaori::SetLogName("kaori-input-latency");
  kaori::latency::Settings settings;
  kaori::Options options(kaori::latency::kHelp);
  options.Text("--mode", settings.mode)
      .Text("--loaded", settings.loaded)
      .Text("--events", settings.events)
      .Text("--rounds", settings.rounds);
  options.Text("--stage", settings.stage).Text("--board", settings.board).Text("--pack", settings.pack, true);
  options.Text("--fdkeeper", settings.fdkeeper);
  if (const auto status = options.Parse(argc, argv)) return *status;
  return kaori::latency::Run(settings);
}
