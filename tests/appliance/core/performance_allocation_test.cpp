// The frame path allocates nothing: the heap may wait for another thread, and a picture may not.
#include <memory>

#include "hw-sim/evening/allocations.h"
#include "tests/appliance/core/life_fixture.h"

namespace kaori::performance {
namespace {

TEST_F(LifeTest, AllocatesNothingInAFrameWhateverSheDoesByHerself) {
  show_.cue_list.cues = {{.number = "1", .life = show::LifeAmounts{2, 1, 1, 1, 2}, .gaze = kWing}};
  show::Track(show_);
  show_.buttons[26] = {show::CallKind::kExpression, 5, show::CallMode::kToggle};
  show_.buttons[27] = {show::CallKind::kFace, 2, show::CallMode::kMomentary};
  show_.buttons[28] = {show::CallKind::kSheet, 1, show::CallMode::kToggle};
  int blinks = 0, glances = 0, accents = 0;
  const auto live = [&](Duration time) {
    for (const Time end = now_ + time; now_ < end;) {
      const Life before = state_.life;
      const float blink_s = state_.blink_s[0];
      Frame();
      blinks += state_.blink_s[0] < blink_s ? 1 : 0;
      glances += state_.life.gaze.to_m != before.gaze.to_m ? 1 : 0;
      accents += state_.life.accents.brow_s < before.accents.brow_s ? 1 : 0;
    }
  };
  const std::size_t before = sim::AllocationCount();
  live(20s);
  CallCueByFoot();
  for (int word = 0; word < 20; ++word) {
    Speak(word % 2 == 0 ? -15.0F : -45.0F);
    live(500ms);
  }
  board_.sticks[0].value.x = 0.7F;  // A hand takes the head, and then the eyes.
  live(5s);
  board_.sticks[1].value.x = 0.4F;
  live(2s);
  board_.sticks[0].value.x = board_.sticks[1].value.x = 0;
  Push(5 + kWinks);
  for (const int button : {26, 27, 28}) Push(button);  // A toggle, a button that is held, the second sheet.
  board_.surface.value.buttons_down = 1U << 27U;
  live(1s);
  board_.surface.value.buttons_down = 0;
  Strike(0x20);
  live(10s);
  EXPECT_EQ(sim::AllocationCount() - before, 0U);
  EXPECT_GT(blinks, 10);
  EXPECT_GT(glances, 20);
  EXPECT_GT(accents, 3);
  const std::size_t counted = sim::AllocationCount();
  const auto proof = std::make_unique<int>(1);
  EXPECT_EQ(sim::AllocationCount(), counted + 1) << "the heap is not counted";
}

}  // namespace
}  // namespace kaori::performance
