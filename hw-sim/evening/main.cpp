// kaori-evening: plays a whole evening in simulated time, once or again and again, and says what came of it.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/base/whole_file.h"
#include "hw-sim/evening/evening.h"

namespace {

using kaori::Result;

constexpr std::string_view kHelp =
    R"(kaori-evening: plays a running order in the whole system in simulated time, with a verdict at its end

  --pack FILE        the show (needed)
  --order FILE       the running order (needed)
  --minutes 10       only so much of its beginning; without this, all of it
  --seed 1           of what operators do between its lines
  --hours 24         again and again, each time with the next seed, until so many hours of show time are played
  --json FILE        what came of it, for programs
)";

constexpr kaori::Duration kTellEvery = std::chrono::minutes(1);  // Of real time.

// The signal handler writes it and the main thread reads it: its type is safe in a handler.
volatile std::sig_atomic_t stop_asked = 0;

// The texts of the options; numbers are parsed by main, which refuses what is none.
struct Settings {
  std::string pack, order, minutes = "0", hours = "0", seed = "1", json;
};

// One line a minute of real time; false once somebody has pressed Ctrl-C.
class Progress {
 public:
  bool Tell(const kaori::sim::Verdict& before, const kaori::sim::Verdict& evening, std::uint64_t seed) {
    if (wall_.now() >= next_) {
      next_ += kTellEvery;
      fmt::print(
          "minute {:.0f} of the evening with seed {}: {} cues, {} missed; {} faults, {} not answered; "
          "before it {} evenings with {} things wrong\n",
          evening.minutes, seed, evening.cues, evening.missed_cues, evening.faults, evening.unanswered_faults,
          before.evenings, before.wrong.size());
      static_cast<void>(std::fflush(stdout));
    }
    return stop_asked == 0;
  }

 private:
  kaori::SteadyClock wall_;
  kaori::Time next_ = wall_.now() + kTellEvery;
};

Result<void> WriteReport(const std::string& file, const kaori::sim::Verdict& verdict) {
  if (file.empty()) return {};
  std::error_code none;
  if (const auto folder = std::filesystem::path(file).parent_path(); !folder.empty())
    std::filesystem::create_directories(folder, none);
  const std::string text = kaori::json::Write(kaori::sim::ToJson(verdict), 2) + "\n";
  return kaori::WriteWholeFile(file, {kaori::AsBytes(text)});
}

void Print(const kaori::sim::Verdict& verdict) {
  for (const std::string& sentence : WhatIsWrong(verdict)) fmt::print("{}\n", sentence);
  fmt::print(
      "{}{} evening{}, {:.0f} minutes in {:.0f} s: {} cues, {} missed; {} faults, {} not answered; "
      "{} frames of the log, {} differ; {} pictures, {} wrong\n{}\n",
      verdict.stopped ? "stopped: " : "", verdict.evenings, verdict.evenings == 1 ? "" : "s", verdict.minutes,
      verdict.seconds, verdict.cues, verdict.missed_cues, verdict.faults, verdict.unanswered_faults,
      verdict.frames, verdict.replay_bits_differ, verdict.pictures, verdict.wrong_pictures,
      IsGood(verdict) ? "All is as it must be." : "Not all is as it must be.");
}

// Evenings until `hours` are played, one at least. What was reached is written also where one of them cannot
// be played on.
int PlayAll(const Settings& settings, const kaori::sim::RunningOrder& order, kaori::stage::Studio& studio,
            double hours, std::uint64_t seed, bool whole) {
  kaori::sim::Verdict all;
  Progress progress;
  int status = 0;
  do {
    auto evening = kaori::sim::PlayEvening(
        order,
        {.file = settings.order,
         .folder = std::filesystem::temp_directory_path() / fmt::format("kaori-evening-{}", ::getpid()),
         .seed = seed,
         .tell = [&](const kaori::sim::Verdict& so_far) { return progress.Tell(all, so_far, seed); }},
        studio);
    if (!evening) {
      status = kaori::ExitWithError(evening.error());
      break;
    }
    // In a long run the same sentence comes from many evenings: the seed says how to play that one again.
    if (hours > 0)
      for (std::string& sentence : evening->wrong) sentence += fmt::format(" (seed {})", seed);
    Add(*evening, all);
    ++seed;
    // With 0 hours the condition is false at once, and one evening is played.
  } while (all.minutes / 60 < hours && stop_asked == 0);
  // The least numbers of cues and faults hold only for evenings that were played to their end.
  all.whole = whole && status == 0 && !all.stopped;
  Print(all);
  if (auto written = WriteReport(settings.json, all); !written) return kaori::ExitWithError(written.error());
  return status != 0 || !IsGood(all) ? 1 : 0;
}

int Play(const Settings& settings, double minutes, double hours, std::uint64_t seed) {
  auto show = kaori::show::LoadPack(settings.pack);
  if (!show) return kaori::ExitWithError(show.error());
  auto order = kaori::sim::LoadRunningOrder(settings.order, *show);
  if (!order) return kaori::ExitWithError(order.error());
  // The value 0 stands for all of the order.
  if (minutes > 0) Shorten(*order, kaori::FromSeconds(minutes * 60));
  const auto studio = kaori::stage::Studio::Open(std::move(*show));
  if (!studio) return kaori::ExitWithError(studio.error());
  return PlayAll(settings, *order, **studio, hours, seed, minutes <= 0);
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-evening");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--pack", settings.pack, true)
      .Text("--order", settings.order, true)
      .Text("--minutes", settings.minutes)
      .Text("--hours", settings.hours)
      .Text("--seed", settings.seed)
      .Text("--json", settings.json);
  if (const auto status = options.Parse(argc, argv)) return *status;
  const auto minutes = kaori::ParseNumber<double>(settings.minutes),
             hours = kaori::ParseNumber<double>(settings.hours);
  const auto seed = kaori::ParseNumber<std::uint64_t>(settings.seed);
  if (!minutes || !(*minutes >= 0) || !hours || !(*hours >= 0) || !seed) {
    kaori::LogError("--minutes and --hours are numbers from 0 on, --seed is a whole one");
    return 2;
  }
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stop_asked = 1; });
  return Play(settings, *minutes, *hours, *seed);
}
