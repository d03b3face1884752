// The cue list of the default show: a jump from anywhere to anywhere is the run through it.
#include "appliance/core/show/pack.h"
#include "tests/appliance/core/cues_fixture.h"

namespace kaori::performance {
namespace {

class DefaultList : public CuesTest {
 protected:
  // Where the list comes to rest, cue by cue of those that GO plays; the first is its top.
  struct Rest {
    State state;
    Tracked tracked;
  };

  DefaultList() {
    show_ = show::LoadPack(KAORI_PACK).value();
    show_.lobby.reset();  // Nobody sleeps here.
    state_ = Opening(show_, board_, now_);
    SetKnob(Knob::kLife, 0);
    Run(5s);
  }

  // Until the cue, with all that it brings by itself, has ended.
  void Rests() {
    while (run().pending >= 0) Run(1s);
    Run(20s);
  }

  std::vector<Rest> RunThrough() {
    std::vector<Rest> rests{{state_, Now()}};
    while (run().standby < static_cast<std::int32_t>(show_.cue_list.cues.size())) {
      Strike(kGo);
      Rests();
      rests.push_back({state_, Now()});
    }
    return rests;
  }
};

TEST_F(DefaultList, AJumpFromAnyCueToAnyOtherEqualsTheRunThroughToTheBit) {
  const auto rests = RunThrough();
  ASSERT_GE(rests.size(), 30U);
  int differ = 0, jumps = 0;
  for (const Rest& from : rests)
    for (const Rest& to : rests) {
      state_ = from.state;
      now_ = from.state.last;
      board_.keys.value = {};
      state_.seen = SeenOn(board_);
      Push(9);  // A hand calls something meanwhile.
      Run(200ms);
      GoToCue(state_, show_, to.tracked.active);
      Run(3s);
      const bool same = SameBits(to.tracked, Now());
      EXPECT_TRUE(same) << "from cue number " << from.tracked.active << " to " << to.tracked.active;
      differ += same ? 0 : 1;
      ++jumps;
    }
  RecordProperty("jumps", jumps);
  RecordProperty("jump_states_differ", differ);
}

}  // namespace
}  // namespace kaori::performance
