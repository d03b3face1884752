// A performance whose input a test moves.
#pragma once

#include <gtest/gtest.h>

#include "appliance/core/board/press_log.h"
#include "appliance/core/performance/animate.h"

namespace kaori::performance {
using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

inline constexpr Duration kFrame = 16'666'667ns;
inline constexpr std::uint8_t kSpace = 0x2C, kKey1 = 0x1E, kF1 = 0x3A;

inline show::Show SmallShow() {
  show::Show show;
  show.cast.faces.resize(5);
  show.cast.expressions.resize(20);
  for (std::uint16_t i = 0; i < 32; ++i)
    show.buttons[i] = i < 5    ? show::Call{show::CallKind::kFace, i}
                      : i < 21 ? show::Call{show::CallKind::kExpression, static_cast<std::uint16_t>(i - 5)}
                      : i < 26 ? show::Call{show::CallKind::kStyle, static_cast<std::uint16_t>(i - 21)}
                               : show::Call{};
  show.scenes.resize(2);
  show.scenes[1].key_usage = kF1;
  show.scenes[1].face = 4;
  show.scenes[1].expression = 3;
  show.scenes[1].style = scene::Style::kFlat;
  show.scenes[1].backdrop = {{0.8F, 0.1F, 0.1F}, {0.2F, 0, 0}, scene::BackdropKind::kCurtain};
  show.motions = {{.name = "nod",
                   .key_usage = kKey1,
                   .curves = {{show::MotionTarget::kHeadPitch, 0, {{0, 0}, {0.2F, -0.2F}, {0.6F, 0}}}}}};
  show.channels = {
      .brow_up = {16, 17}, .brow_frown = 18, .lids_up = 19, .lids_down = 15, .mouth = {11, 12, 13, 14}};
  return show;
}

// A performance whose input a test moves; life is quiet unless asked for.
// The motion that was called last, of those that play or end; null: none. Borrowed from the state.
inline const Playing* LastCalled(const State& state) {
  const Playing* last = nullptr;
  for (const Playing& voice : state.voices)
    if (voice.motion >= 0 && (last == nullptr || voice.number > last->number)) last = &voice;
  return last;
}

class PerformanceTest : public ::testing::Test {
 protected:
  PerformanceTest() : state_(Opening(show_, board_, now_)) {
    board_.surface.source = board_.keys.source = board::SourceState::kLive;
    SetKnob(Knob::kLife, 0);
  }

  void SetKnob(Knob knob, float value) {
    state_.knobs[static_cast<std::size_t>(knob)] = state_.shown[static_cast<std::size_t>(knob)] = value;
  }
  void Push(int button) { board::NotePress(board_.surface.value, static_cast<std::size_t>(button), now_); }
  void Strike(std::uint8_t usage) { board::NotePress(board_.keys.value, usage, now_); }
  // As kaori-input does it for the foot switch.
  void CallCueByFoot() { Make({.verb = board::CallVerb::kCue, .source = board::CallSource::kFootSwitch}); }
  // A call on the board, made now.
  void Make(board::Call call, board::CallWriter writer = board::CallWriter::kInput) {
    auto& calls = board_.calls[static_cast<std::size_t>(writer)];
    call.at = call.at == Time{} ? now_ : call.at;
    calls.source = board::SourceState::kLive;
    board::Append(calls.value, call);
  }
  void Live() {
    for (auto& stick : board_.sticks) stick.source = board::SourceState::kLive;
  }
  const scene::Scene& Step(Duration by = kFrame) {
    now_ += by;
    const InputEvents events = ReadEvents(state_.seen, board_);
    performed_ = Animate(state_, board_, events, show_, now_);
    state_ = performed_.state;
    return performed_.scene;
  }
  const scene::Scene& Run(Duration time) {
    for (const Time end = now_ + time; now_ < end;) Step();
    return performed_.scene;
  }
  float Weight(const face::Terms& terms, int index) const {
    float weight = 0;
    for (const auto& t : terms)
      if (t.index == index) weight += t.weight;
    return weight;
  }

  show::Show show_ = SmallShow();
  board::Snapshot board_;
  Time now_ = Time{} + 100s;
  State state_;
  Performed performed_;
};

}  // namespace kaori::performance
