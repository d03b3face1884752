// The latency from an event on the cable to the scan-out of the frame that shows it.
#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/unplugged_device.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// For machines that have little of a processor.
constexpr Duration kLatencyAnswer = seconds(60);
// Longer than a frame of a slow machine, so that events do not overtake each other.
constexpr Duration kBetween = milliseconds(90);
// The two clocks agree no better than a question takes to be answered.
constexpr std::int64_t kClockDoubt_ns = 3'000'000;

// All by the machine's clock.
struct EventTimes {
  // When the simulated stick moved, when the board had it, and when input was sampled for a frame
  // that was presented at the second time.
  std::vector<std::int64_t> sent_ns;
  std::vector<std::int64_t> arrived_ns;
  std::vector<std::pair<std::int64_t, std::int64_t>> flips;
};

// Lines of the agent: "stick NANOSECONDS" and "flip SAMPLED PRESENTED".
// Times are nanoseconds of the machine's clock; a line of another kind is passed over.
void ReadMoments(const std::string& told, EventTimes& moments) {
  std::istringstream lines(told);
  std::string kind;
  for (std::int64_t a = 0; lines >> kind >> a;) {
    double b = 0;
    lines >> b;
    if (kind == "stick") moments.arrived_ns.push_back(a);
    if (kind == "flip") moments.flips.emplace_back(a, static_cast<std::int64_t>(b));
  }
}

// What the machine's clock is ahead of ours, from the question that was answered soonest:
// the answer is taken to be made in the middle of its time, as NTP does (RFC 5905), so
// half of that time bounds the error.
Result<std::int64_t> ClockAhead(Scene& scene) {
  constexpr int kQuestions = 12;
  Duration soonest = Duration::max();
  std::int64_t ahead_ns = 0;
  for (int n = 0; n < kQuestions; ++n) {
    const Time asked = scene.target.clock().now();
    const auto told = scene.target.agent().Ask("clock", kLatencyAnswer);
    if (!told) return tl::unexpected(told.error());
    const Duration took = scene.target.clock().now() - asked;
    if (took >= soonest) continue;
    soonest = took;
    ahead_ns = std::strtoll(told->c_str(), nullptr, 10) - (asked + took / 2).time_since_epoch().count();
  }
  return ahead_ns;
}

// Shakes the left stick for so long, and returns what the in-guest agent saw of it.
Result<EventTimes> Shake(Scene& scene, int watch_ms) {
  const auto ahead_ns = ClockAhead(scene);
  if (!ahead_ns) return tl::unexpected(ahead_ns.error());
  sim::StickPod& stick = scene.target.rig().devices().left_stick;
  EventTimes moments;
  Time next = scene.target.clock().now();
  bool right = false;
  // Called whenever the bench waits: while the agent watches, the stick is moved from here.
  scene.target.SetInput([&](Time now) {
    if (now < next) return;
    next = now + kBetween;
    right = !right;
    stick.Move(right ? 0.7F : -0.7F, 0);
    moments.sent_ns.push_back(now.time_since_epoch().count() + *ahead_ns);
  });
  const auto told =
      scene.target.agent().Ask(fmt::format("events {}", watch_ms), milliseconds(watch_ms) + kLatencyAnswer);
  scene.target.SetInput({});
  stick.Move(0, 0);
  if (!told) return tl::unexpected(told.error());
  ReadMoments(*told, moments);
  return moments;
}

// What an operator feels, in milliseconds: to the board, and to the scan-out of the frame that shows it.
struct Latencies {
  std::vector<double> to_board_ms;
  std::vector<double> to_flip_ms;
};

// Of each event that was not overtaken by the next one before the board had it. An event
// counts as arrived at the first change of the board after it, and as shown by the first
// frame whose input was sampled after that.
Latencies LatenciesOf(const EventTimes& moments) {
  Latencies ways;
  for (std::size_t n = 0; n + 1 < moments.sent_ns.size(); ++n) {
    const std::int64_t sent = moments.sent_ns[n];
    const auto arrived = std::ranges::lower_bound(moments.arrived_ns, sent - kClockDoubt_ns);
    if (arrived == moments.arrived_ns.end() || *arrived >= moments.sent_ns[n + 1] - kClockDoubt_ns) continue;
    const auto shown =
        std::ranges::find_if(moments.flips, [&](const auto& flip) { return flip.first >= *arrived; });
    ways.to_board_ms.push_back(static_cast<double>(*arrived - sent) / 1e6);
    if (shown != moments.flips.end())
      ways.to_flip_ms.push_back(static_cast<double>(shown->second - sent) / 1e6);
  }
  return ways;
}

// In frames of the screen as it ran meanwhile: an emulated machine's milliseconds say little.
void Tell(const EventTimes& moments, const Latencies& ways, Finding& finding) {
  // The mean time from flip to flip while it was measured.
  const double frame_ms = static_cast<double>(moments.flips.back().second - moments.flips.front().second) /
                          1e6 / static_cast<double>(moments.flips.size() - 1);
  const double median = Quantile(ways.to_flip_ms, 0.5) / frame_ms,
               p99 = Quantile(ways.to_flip_ms, 0.99) / frame_ms;
  finding.figures["event_to_flip_frames_median"] = median;
  finding.figures["event_to_flip_frames_p99"] = p99;
  finding.figures["event_to_board_ms_median"] = Quantile(ways.to_board_ms, 0.5);
  finding.said = fmt::format(
      "{} events: to the board {:.1f} ms (median), {:.1f} ms (p99); to the flip {:.2f} frames (median), "
      "{:.2f} (p99), of {:.0f} ms",
      ways.to_flip_ms.size(), Quantile(ways.to_board_ms, 0.5), Quantile(ways.to_board_ms, 0.99), median, p99,
      frame_ms);
}

// Watches until enough frames came: a busy machine draws one in many seconds.
Result<EventTimes> ShakeUntilSeen(Scene& scene) {
  constexpr int kWatchMs = 20'000, kMostWatches = 6;
  constexpr std::size_t kWantedFlips = 8;
  EventTimes all;
  // Times of several watches are put together: each has its own offset of the clocks.
  for (int n = 0; n < kMostWatches && all.flips.size() < kWantedFlips; ++n) {
    auto moments = Shake(scene, kWatchMs);
    if (!moments) return moments;
    all.sent_ns.insert(all.sent_ns.end(), moments->sent_ns.begin(), moments->sent_ns.end());
    all.arrived_ns.insert(all.arrived_ns.end(), moments->arrived_ns.begin(), moments->arrived_ns.end());
    all.flips.insert(all.flips.end(), moments->flips.begin(), moments->flips.end());
  }
  return all;
}

// That no event comes, or hardly a frame, is a failure; how long they take is none: an emulated machine's times say little
// about a real one's, and are told as they are.
Result<void> Latency(Scene& scene) {
  constexpr std::size_t kLeastFlips = 4;
  const UnpluggedDevice camera(scene, "camera", seconds(5));  // Its pictures cost an emulated machine much.
  const auto moments = ShakeUntilSeen(scene);
  if (!moments) return tl::unexpected(moments.error());
  if (moments->arrived_ns.empty()) return FailInput("no event came to the board");
  const Latencies ways = LatenciesOf(*moments);
  if (moments->flips.size() >= kLeastFlips && !ways.to_flip_ms.empty())
    return Tell(*moments, ways, scene.finding), Result<void>{};
  return FailInput(fmt::format("{} frames came, which is too few to measure by", moments->flips.size()));
}

}  // namespace

std::vector<Check> LatencyChecks() {
  return {{"latency",
           "From an event on the cable to the flip that shows it",
           true,
           Latency,
           {},
           "kaori-input.service"}};
}

}  // namespace kaori::hil
