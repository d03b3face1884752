// A performance with a cue list, whose keys call GO, BACK and the rest.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>

#include "appliance/core/performance/cues.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {

using show::CueNext;
using show::CuePerson;
using show::CueVerb;

inline constexpr std::uint8_t kGo = 0x28, kBack = 0x2A, kPanic = 0x29, kStop = 0x16, kPause = 0x13,
                              kBlack = 0x05;

// Seven cues: a face, a style, a chain of three, a scene, and a level.
inline show::Show ShowWithCues() {
  show::Show show = SmallShow();
  show.scenes.resize(3);
  show.scenes[2].face = 2;
  show.scenes[2].expression = 6;
  show.scenes[2].exposure = 0.7F;
  auto& cues = show.cue_list.cues;
  cues = {{.number = "1", .face = show::CueCall{1, 0.5F}},
          {.number = "2", .face = show::CueCall{3, 1.0F}, .style = show::CueCall{0, 2.0F}, .gaze = 1},
          {.number = "2.5", .expression = show::CueCall{4, 0.5F}, .next = CueNext::kContinue},
          {.number = "2.10",
           .pre_wait_s = 1,
           .expression = show::CueCall{5, 0.5F},
           .motion = 0,
           .next = CueNext::kFollow},
          {.number = "3",
           .face = show::CueCall{0, 0.2F},
           .light = show::CueLevel{0.5F, 0.5F},
           .life = show::LifeAmounts{1, 0.5F, show::kKeepsLife, show::kKeepsLife, 0},
           .gaze = show::kNoTarget},
          {.number = "4", .scene = show::CueCall{2, 1.0F}, .expression = show::CueCall{7, 1.0F}},
          {.number = "5", .light = show::CueLevel{1, 0.5F}, .present = show::CueLevel{0, 0.5F}}};
  show.gaze_targets = {{show::kHouseName, {0, 0, 4}}, {"seat 12", {-1, 0, 5}}};
  show.cue_list.panic = {1, 0.5F};
  const auto key = [&show](std::uint8_t usage, CueVerb verb) {
    show.keys.push_back({usage, {show::CallKind::kCue, static_cast<std::uint16_t>(verb)}});
  };
  key(kGo, CueVerb::kGo);
  key(kBack, CueVerb::kBack);
  key(kPanic, CueVerb::kPanic);
  key(kStop, CueVerb::kStop);
  key(kPause, CueVerb::kPause);
  key(kBlack, CueVerb::kBlackout);
  show::Track(show);
  return show;
}

class CuesTest : public PerformanceTest {
 protected:
  CuesTest() { Start(); }

  void Start() {
    show_ = ShowWithCues();
    board_.keys.value = {};
    state_ = Opening(show_, board_, now_);
    SetKnob(Knob::kLife, 0);
  }
  void Go() {
    Strike(kGo);
    Run(400ms);
  }
  // Calls play(first, second) from the start, where each of the two calls GO once, by the foot switch or by its
  // key: for all four pairs of them.
  template <class Play>
  void ForEachTwoGos(Play play) {
    const auto tread = [this] { CallCueByFoot(); };
    const auto strike = [this] { Strike(kGo); };
    const std::array<std::function<void()>, 2> sources{tread, strike};
    for (const auto& first : sources)
      for (const auto& second : sources) {
        Start();
        play(first, second);
      }
  }
  const CueRun& run() const { return state_.cue_run; }
  int Face() const { return state_.faces.to; }
  int Expression() const { return state_.expressions.to; }

  // What the list determines of a state, to the bit.
  struct Tracked {
    Mixture faces, expressions, styles, backdrops;
    Fading exposure, light, present;
    std::array<float, 2> dials;
    std::int32_t active, standby;
    std::uint16_t scene;
    show::LifeAmounts life;
    std::int32_t gaze;
  };
  static bool SameBits(const Tracked& a, const Tracked& b) {
    // Bits, and not values: 0 and -0 differ.
    const auto same = []<class T>(const T& x, const T& y) {
      using Words = std::array<std::uint32_t, sizeof(T) / sizeof(std::uint32_t)>;
      return std::bit_cast<Words>(x) == std::bit_cast<Words>(y);
    };
    const auto same_mixture = [&same](const Mixture& x, const Mixture& y) {
      return x.to == y.to && same(x.progress, y.progress) && same(x.duration_s, y.duration_s) &&
             std::ranges::equal(x.from, y.from, [](const face::Term& s, const face::Term& t) {
               return s.index == t.index && s.weight == t.weight;
             });
    };
    return same_mixture(a.faces, b.faces) && same_mixture(a.expressions, b.expressions) &&
           same_mixture(a.styles, b.styles) && same_mixture(a.backdrops, b.backdrops) &&
           same(a.exposure, b.exposure) && same(a.light, b.light) && same(a.present, b.present) &&
           same(a.dials, b.dials) && same(a.life, b.life) && a.gaze == b.gaze && a.active == b.active &&
           a.standby == b.standby && a.scene == b.scene;
  }
  Tracked Now() const {
    return {state_.faces,      state_.expressions,
            state_.styles,     state_.backdrops,
            state_.exposure,   state_.cue_light,
            state_.present,    {At(state_.shown, Knob::kFace), At(state_.shown, Knob::kExpression)},
            run().active,      run().standby,
            state_.scene,      state_.life.called,
            state_.life.target};
  }
  // Plays the list from its top until GO would play cue `end`.
  Tracked RunThroughTo(std::int32_t end) {
    Start();
    while (run().standby < end) {
      Strike(kGo);
      Run(6s);
    }
    return Now();
  }
};

}  // namespace kaori::performance
