// A performance with toggles, buttons that are held, and a second sheet of buttons.
#pragma once

#include "appliance/core/performance/kept.h"
#include "tests/appliance/core/levels_fixture.h"

namespace kaori::performance {

using show::CallKind;
using show::CallMode;

class KeptTest : public LevelsTest {
 protected:
  static constexpr std::uint16_t kAngry = 3, kLaughs = 4, kDog = 2;
  static constexpr int kToggleAngry = 26, kToggleLaugh = 27, kHoldAngry = 28, kHoldDog = 29, kSheet2 = 30,
                       kGo = 31;

  KeptTest() {
    show_.buttons[kToggleAngry] = {CallKind::kExpression, kAngry, CallMode::kToggle};
    show_.buttons[kToggleLaugh] = {CallKind::kExpression, kLaughs, CallMode::kToggle};
    show_.buttons[kHoldAngry] = {CallKind::kExpression, kAngry, CallMode::kMomentary};
    show_.buttons[kHoldDog] = {CallKind::kFace, kDog, CallMode::kMomentary};
    show_.buttons[kSheet2] = {CallKind::kSheet, 1, CallMode::kToggle};
    show_.buttons[kGo] = {CallKind::kCue, static_cast<std::uint16_t>(show::CueVerb::kGo)};
    show_.second_buttons[kSheet2] = show_.buttons[kSheet2];
    show_.second_buttons[0] = {CallKind::kExpression, 7};
    show_.expression_fades.resize(kLaughs + 1U);
    show_.expression_fades[kAngry] = {.in_s = 0.5F, .out_s = 2, .curve = show::FadeCurve::kLinear};
    show_.expression_fades[kLaughs] = {.in_s = 0, .out_s = 0};
    state_ = Opening(show_, board_, now_);
    SetKnob(Knob::kLife, 0);
    Step();
  }

  void HoldDown(int button) {
    Push(button);
    board_.surface.value.buttons_down |= 1U << static_cast<unsigned>(button);
  }
  void LetUpAll() { board_.surface.value.buttons_down = 0; }
  float Expression(int index) const { return Weight(performed_.scene.weights.expressions, index); }
  float Face(int index) const { return Weight(performed_.scene.weights.faces, index); }
  bool IsLampLit(int button) const { return (performed_.lamps >> static_cast<unsigned>(button) & 1U) != 0; }
};

}  // namespace kaori::performance
