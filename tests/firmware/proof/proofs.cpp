#include "tests/firmware/proof/proofs.h"

#include "firmware/surface/axis.h"
#include "firmware/surface/buttons.h"
#include "firmware/surface/dial_box.h"
#include "firmware/surface/dials.h"
#include "tests/firmware/proof/ideal_hand.h"

namespace kaori::proof {
namespace {

constexpr std::uint32_t kSwitches = 32;

std::uint32_t Distance(std::uint32_t one, std::uint32_t other) {
  const auto ahead = static_cast<std::int32_t>(one - other);
  return static_cast<std::uint32_t>(ahead < 0 ? -ahead : ahead);
}

// All switches' lines at one look.
class SwitchPanel {
 public:
  BouncingSwitch& operator[](std::size_t n) { return switches_[n]; }
  std::uint32_t Look(Dice& dice) {
    std::uint32_t closed = 0;
    for (std::uint32_t n = 0; n < kSwitches; ++n)
      if (switches_[n].Look(dice)) closed |= std::uint32_t{1} << n;
    return closed;
  }

 private:
  std::array<BouncingSwitch, kSwitches> switches_{};
};

// Disturbs one line for a look or two, and then leaves it alone for longer than that.
class Spikes {
 public:
  std::uint32_t Next(Dice& dice) {
    if (left_ == 0) {
      line_ = std::uint32_t{1} << dice.Throw(kSwitches);
      left_ = 8 + dice.Throw(8);
    }
    --left_;
    return left_ < 2 ? line_ : 0;
  }

 private:
  std::uint32_t line_ = 0;
  std::uint32_t left_ = 0;
};

}  // namespace

DialProof ProveDials(std::uint64_t edges, std::uint32_t seed) {
  Dice dice(seed);
  DialHand hand;
  surface::Dials dials;
  DialProof proof;
  std::array<std::uint32_t, wire::kDials> expected{};
  std::array<std::int32_t, wire::kDials> way{1, -1, 1, -1, 1, -1, 1, -1};
  std::uint32_t doubles = 0;
  // Where they stand when the power comes counts nothing.
  for (std::size_t dial = 0; dial < expected.size(); ++dial)
    hand.Turn(dial, static_cast<std::int32_t>(dice.Throw(4)));
  dials.Look(hand.lines());
  while (proof.edges < edges) {
    // Which dials go one count at this look; at full speed that is all of them.
    const std::uint32_t moving = dice.Throw();
    for (std::size_t dial = 0; dial < expected.size(); ++dial) {
      const std::uint32_t chance = moving >> (4 * dial) & 0xFU;
      if (chance < 4) continue;
      if (chance == 4) way[dial] = -way[dial];  // Turns round: what a contact that chatters does too.
      const bool is_double = chance == 5 && dice.OneIn(64);
      hand.Turn(dial, is_double ? 2 * way[dial] : way[dial]);
      if (is_double) {
        ++doubles;
      } else {
        expected[dial] += static_cast<std::uint32_t>(way[dial]);
      }
      ++proof.edges;
    }
    dials.Look(hand.lines());
  }
  for (std::size_t dial = 0; dial < expected.size(); ++dial)
    proof.counts_lost += Distance(dials.position(dial), expected[dial]);
  proof.double_steps_untold = Distance(dials.double_steps(), doubles);
  return proof;
}

ButtonProof ProveButtons(std::uint32_t changes, std::uint32_t bouncing_looks, std::uint32_t seed) {
  // A spike while a switch trembles makes the tremble longer: both may add up.
  const std::uint32_t patience = bouncing_looks + 3 * surface::Buttons::kLooksToRelease;
  Dice dice(seed);
  SwitchPanel panel;
  Spikes spikes;
  surface::Buttons buttons;
  ButtonProof proof;
  std::uint32_t expected = 0;
  for (std::uint32_t change = 0; change < changes; ++change) {
    const std::uint32_t n = dice.Throw(kSwitches);
    const std::uint32_t bit = std::uint32_t{1} << n;
    const bool down = (expected & bit) == 0;
    panel[n].Set(down, bouncing_looks);
    std::uint32_t edges = 0, before = buttons.pressed();
    std::uint32_t told_after = 0;
    for (std::uint32_t look = 1; look <= patience; ++look) {
      const std::uint32_t spike = bouncing_looks == 0 ? spikes.Next(dice) & ~bit : 0;
      const std::uint32_t now = buttons.Look(panel.Look(dice) ^ spike);
      if (((now ^ before) & bit) != 0) told_after = look, ++edges;
      if (((now ^ expected) & ~bit) != 0) ++proof.wrong;  // A ghost.
      before = now;
    }
    expected ^= bit;
    if (edges != 1 || buttons.pressed() != expected) ++proof.wrong;
    auto& longest = down ? proof.longest_press_looks : proof.longest_release_looks;
    if (told_after > longest) longest = told_after;
    ++proof.changes;
  }
  return proof;
}

namespace {

// Anywhere on its way, with half a code of noise, for half a second. It comes to rest within the first tenth of it.
std::uint64_t ReportsOfASliderThatLies(Dice& dice) {
  constexpr surface::AxisEnds kEnds;
  constexpr std::uint32_t kSamples = 2000;
  surface::AxisFilter filter;
  surface::AxisGate gate;
  std::uint64_t reports = 0;
  const std::uint32_t lies = 500 + dice.Throw(3000);
  for (std::uint32_t n = 0; n < kSamples; ++n) {
    if (!filter.Sample(static_cast<std::uint16_t>(lies + dice.Throw(2)))) continue;
    const bool is_told = gate.Accept(surface::SliderValue(filter.value_q4(), kEnds), 0, 65535);
    reports += is_told && n > kSamples / 5 ? 1 : 0;
  }
  return reports;
}

}  // namespace

AxisProof ProveAxes(std::uint32_t rounds, std::uint32_t seed) {
  constexpr surface::AxisEnds kEnds;
  constexpr std::uint16_t kRestCode = kEnds.centre / 4;
  Dice dice(seed);
  surface::AxisFilter filter;
  AxisProof proof;
  // Runs the converter at `code` for some milliseconds, four samples each, and returns the value.
  const auto run = [&](std::uint16_t code, std::uint32_t ms) {
    for (std::uint32_t n = 0; n < 4 * ms; ++n)
      filter.Sample(static_cast<std::uint16_t>(code + dice.Throw(3) - 1));
    return surface::AxisValue(filter.value_q4(), kEnds);
  };
  for (std::uint32_t round = 0; round < rounds; ++round) {
    // At rest, trembling: nothing is told.
    if (run(kRestCode, 30) != 0) ++proof.wrong;
    surface::AxisGate resting;
    for (int n = 0; n < 50; ++n)
      if (resting.Accept(run(kRestCode, 1), -32767, 32767)) ++proof.reports_at_rest;
    proof.reports_at_rest += ReportsOfASliderThatLies(dice);
    // Neither is one sample that is far off, wherever among the four of a sum it comes.
    run(kRestCode, 10);
    for (std::uint32_t n = dice.Throw(4); n > 0; --n) filter.Sample(kRestCode);
    filter.Sample(static_cast<std::uint16_t>(dice.OneIn(2) ? 4095 : 0));
    for (int n = 0; n < 10; ++n)
      if (run(kRestCode, 1) != 0) ++proof.wrong;
    // A step to a side.
    const auto code =
        static_cast<std::uint16_t>(dice.OneIn(2) ? 200 + dice.Throw(1500) : 2400 + dice.Throw(1500));
    const std::int32_t sign = code < kRestCode ? -1 : 1;
    std::int32_t last = 0;
    std::array<std::int32_t, 32> path{};
    for (auto& value : path) value = run(code, 1);
    for (std::uint32_t ms = 0; ms < path.size(); ++ms) {
      if (path[ms] * sign < 0 || path[ms] < -32767) ++proof.wrong;
      // It goes there and does not come back, but for the tremble.
      if ((path[ms] - last) * sign < -64) ++proof.wrong;
      last = path[ms];
      if (path[ms] * sign * 100 < path.back() * sign * 95 && ms + 2 > proof.longest_ms)
        proof.longest_ms = ms + 2;
    }
  }
  // A slow turn is told in fine steps.
  surface::AxisGate gate;
  std::int32_t finest = 65536;
  for (std::int32_t way = 0; way < 3000; ++way) {
    const std::int32_t before = gate.told();
    if (gate.Accept(5000 + 3 * way, -32767, 32767) && way > 0 && gate.told() - before < finest)
      finest = gate.told() - before;
  }
  if (finest > 6) ++proof.wrong;
  // The ends are reached, and nothing is beyond them.
  if (run(1, 40) != -32767 || run(4094, 40) != 32767) ++proof.wrong;
  if (surface::SliderValue(0, kEnds) != 0 || surface::SliderValue(16380 << 4, kEnds) != 65535) ++proof.wrong;
  return proof;
}

ReportProof ProveReports(std::uint32_t looks, std::uint32_t seed) {
  Dice dice(seed);
  DialHand hand;
  surface::DialBox box({}, nullptr);
  ReportProof proof;
  std::array<std::uint32_t, wire::kDials> told{};
  std::uint32_t told_buttons = 0, pressed = 0, edges_done = 0, edges_told = 0;
  std::uint32_t quiet_until = 0, deaf_until = 0;
  box.Look(hand.lines());
  box.SetHost(surface::Host::kThere);
  for (std::uint32_t look = 1; look <= looks || box.has_news(); ++look) {
    if (look <= looks && dice.OneIn(3)) hand.Turn(dice.Throw(wire::kDials), dice.OneIn(2) ? 1 : -1);
    box.Look(hand.lines());
    if (look % 10 == 0) {
      // A person changes a button each 10 ms at most.
      if (look > quiet_until && look + 4000 < looks) {
        pressed ^= std::uint32_t{1} << dice.Throw(2);
        quiet_until = look + 400;
        ++edges_done;
      }
      box.Tick(pressed);
    }
    // The host polls each millisecond on the average, and now and then not for 50.
    if (dice.OneIn(20'000)) deaf_until = look + 2000;
    if (look < deaf_until || !dice.OneIn(40) || !box.has_news()) continue;
    const auto report = box.NextReport();
    if (!report) continue;
    ++proof.reports;
    for (std::size_t dial = 0; dial < told.size(); ++dial)
      told[dial] += static_cast<std::uint32_t>(std::int32_t{report->turned[dial]});
    for (std::uint32_t changed = report->buttons_down ^ told_buttons; changed != 0; changed &= changed - 1)
      ++edges_told;
    told_buttons = report->buttons_down;
  }
  for (std::size_t dial = 0; dial < told.size(); ++dial)
    if (told[dial] != hand.angle(dial)) ++proof.wrong;
  if (edges_told != edges_done || told_buttons != pressed) ++proof.wrong;
  return proof;
}

}  // namespace kaori::proof
