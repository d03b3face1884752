// The latency from input to scan-out, with input sampled as late as drawing allows and right after each flip,
// on a screen whose vertical blanks come by a timer (vkms, of the bench's kernel): QEMU's own graphics cards
// have none.
#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/paused_unit.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

constexpr Duration kSamplingAnswer = seconds(600);
constexpr Duration kLongestRounds = std::chrono::hours(1);
constexpr double kLeastGain = 1.6, kMostMissed_percent = 0.5, kMostMissedLoaded_percent = 2;

// The screen is small and slow, and the show's first face a plain one drawn flat, so that drawing takes a
// part of its period, as it does on a box.
constexpr std::string_view kPlayRounds =
    "start LP_NUM_THREADS=0 MESA_DISK_CACHE_SINGLE_FILE=1 MESA_SHADER_CACHE_DIR=/run/kaori "
    "MESA_DISK_CACHE_READ_ONLY_FOZ_DBS=../../../../../../../usr/share/kaori/shaders "
    "bench:/usr/bin/kaori-input-latency --mode 160x90@1 --loaded 160x90@1 --events 30 --rounds 1 "
    "--pack bench:/usr/share/kaori/plain.kaori";

// One line of the program: "round arm=late round=0 events=70 mean_ms=190.10 ...".
struct SampledRound {
  std::string arm;
  std::map<std::string, double> values;
};

// Reads lines such as "... round arm=late missed=0.1"; other lines are passed over, and a word that is no
// number counts as 0.
std::vector<SampledRound> ReadRounds(const std::string& said) {
  std::vector<SampledRound> rounds;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("round arm=");
    if (at == std::string::npos) continue;
    SampledRound round;
    std::istringstream words(line.substr(at));
    for (std::string word; words >> word;) {
      const std::size_t equals = std::min(word.find('='), word.size() - 1);
      const std::string name = word.substr(0, equals), value = word.substr(equals + 1);
      if (name == "arm") round.arm = value;
      round.values[name] = std::strtod(value.c_str(), nullptr);
    }
    rounds.push_back(std::move(round));
  }
  return rounds;
}

// Of all rounds of one arm.
std::vector<double> ValuesOf(const std::vector<SampledRound>& rounds, const std::string& arm,
                             const std::string& name) {
  std::vector<double> values;
  for (const SampledRound& round : rounds)
    if (round.arm == arm && round.values.contains(name)) values.push_back(round.values.at(name));
  return values;
}

// Compares the three arms: early, late, and late beside a program that keeps the processor busy, from 30
// frames after that began. Errors: invalid_argument (an arm is missing, or a goal is missed).
Result<void> Judge(const std::string& said, Finding& finding) {
  const auto rounds = ReadRounds(said);
  const auto mean_ms = [&](const char* arm) { return Quantile(ValuesOf(rounds, arm, "mean_ms"), 0.5); };
  const auto sum = [&](const char* arm, const char* name) {
    const auto values = ValuesOf(rounds, arm, name);
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  const auto missed_percent = [&](const char* arm) {
    return 100 * sum(arm, "missed") / std::max(1.0, sum(arm, "frames"));
  };
  auto& figures = finding.figures;
  for (const char* arm : {"early", "late", "loaded"}) {
    if (mean_ms(arm) <= 0) return FailInput(fmt::format("no round of the arm {} ended", arm));
    figures[fmt::format("latency_{}_ms", arm)] = mean_ms(arm);
  }
  const double gain = mean_ms("early") / mean_ms("late");
  const double missed = missed_percent("late"), loaded = missed_percent("loaded");
  figures["latency_gain_over_naive"] = gain;
  figures["missed_flips_percent"] = missed;
  figures["missed_flips_percent_loaded"] = loaded;
  figures["frames_to_adapt"] = Quantile(ValuesOf(rounds, "loaded", "settled"), 1);
  finding.said = fmt::format(
      "{:.1f} ms sampled early, {:.1f} ms sampled late: {:.2f} times less (at least {}); missed flips {:.2f} "
      "% (at most "
      "{}), beside a busy processor {:.2f} % (at most {})",
      mean_ms("early"), mean_ms("late"), gain, kLeastGain, missed, kMostMissed_percent, loaded,
      kMostMissedLoaded_percent);
  const bool good =
      gain >= kLeastGain && missed <= kMostMissed_percent && loaded <= kMostMissedLoaded_percent;
  return good ? Result<void>{} : FailInput(finding.said);
}

// The program plays all rounds instead of the stage's unit; the input program is the box's own.
Result<void> LateSampling(Scene& scene) {
  AgentProtocol& agent = scene.target.agent();
  const PausedUnit stage(scene, "kaori-stage.service"), lips(scene, "kaori-lips.service");
  const auto program = agent.Ask(std::string(kPlayRounds), kSamplingAnswer);
  if (!program) return tl::unexpected(program.error());
  std::string said;
  const auto ended = [&] {
    scene.target.For(seconds(2));
    said = agent.Ask("said " + *program, kSamplingAnswer).value_or(said);
    return said.find("all rounds are played") !=
           std::string::npos;  // "not" stands before it where one failed.
  };
  const auto played = scene.target.Await(ended, kLongestRounds, "see all rounds played");
  static_cast<void>(agent.Ask("end " + *program, kSamplingAnswer));
  scene.finding.texts.emplace_back("kaori-input-latency", said);
  return played ? Judge(said, scene.finding) : played;
}

// The control: input that is sampled early as well, and a flip in a hundred that is missed, are refused.
Result<void> EarlyIsRefused(Scene& scene) {
  constexpr const char* kGood =
      "round arm=early mean_ms=480 missed=0 frames=300\n"
      "round arm=late mean_ms=240 missed=0 frames=300\n"
      "round arm=loaded mean_ms=300 missed=3 frames=300 settled=9\n";
  if (auto ok = Judge(kGood, scene.finding); !ok) return ok;
  for (const auto& [good, wrong] : {std::pair{"late mean_ms=240", "late mean_ms=470"},
                                    {"mean_ms=240 missed=0", "mean_ms=240 missed=3"},
                                    {"missed=3", "missed=9"},
                                    {"arm=late", "arm=none"}}) {
    std::string said = kGood;
    said.replace(said.find(good), std::string_view(good).size(), wrong);
    if (Judge(said, scene.finding)) return FailInput(fmt::format("rounds with \"{}\" pass", wrong));
  }
  return {};
}

}  // namespace

std::vector<Check> SamplingChecks() {
  return {{.name = "late-sampling",
           .sentence = "Input is sampled late, and no flip is missed",
           .run = LateSampling,
           .setup = CountedSetup(),
           .control = EarlyIsRefused,
           .ends_programs = true}};
}

}  // namespace kaori::hil
