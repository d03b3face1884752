// The lobby in the real programs: a sensor on a GPIO line, the voice out of the loudspeaker, and the picture.
#include <algorithm>

#include <gtest/gtest.h>

#include "appliance/core/board/lines.h"
#include "appliance/core/board/show_now.h"
#include "appliance/core/show/pack.h"
#include "tests/system/programs_fixture.h"

namespace kaori::test {
namespace {

using board::LobbyState;

constexpr int kPresence = static_cast<int>(board::Line::kPresence);
constexpr double kHeard_db = -40, kSilent_db = -70;

// The default show, with shorter times, on a box that stands in a foyer.
class LobbyOfABox : public HeldControls {
 protected:
  LobbyOfABox() {
    show::Show show = show::LoadPack(Pack()).value();
    show.lobby->by_itself = true;
    show.lobby->leave_s = 0.5F;
    show.lobby->sleep_s = 2;
    EXPECT_TRUE(show::SavePack(show, programs_.File("lobby.kaori")));
    Start("kaori-input");
    for (const char* program : {"kaori-lips", "kaori-stage"})
      programs_.Start(program, {"--links", programs_.links(), "--board", programs_.board(), "--pack",
                                programs_.File("lobby.kaori")});
  }

  LobbyState Now() const { return board_.Read<board::ShowNow>().value.lobby; }

  // Waits for the lobby to stand so, and keeps the loudest that was heard meanwhile.
  ::testing::AssertionResult Comes(LobbyState wanted) {
    loudest_db_ = -100;
    const auto there = [&] {
      Between();
      loudest_db_ = std::max(loudest_db_, rig_->loudspeaker().level_db());
      return Now() == wanted;
    };
    if (Await(there, std::chrono::seconds(40))) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "the lobby stands at " << static_cast<int>(Now()) << "; "
                                         << programs_.LogOf("kaori-stage") << programs_.LogOf("kaori-lips");
  }

  double loudest_db_ = -100;
};

TEST_F(LobbyOfABox, WakesForWhomTheSensorSeesGreetsAloudSaysGoodByeAndSleepsAgain) {
  ASSERT_TRUE(Comes(LobbyState::kAsleep));
  Hold(std::chrono::seconds(5));
  ASSERT_TRUE(Comes(LobbyState::kAsleep)) << "nobody is there";
  EXPECT_LT(loudest_db_, kSilent_db) << "and she does not speak";
  rig_->lines().Close(kPresence);
  ASSERT_TRUE(Comes(LobbyState::kGreeting));
  ASSERT_TRUE(Comes(LobbyState::kWith));
  EXPECT_GT(loudest_db_, kHeard_db) << "the greeting was heard";
  rig_->lines().Open(kPresence);
  ASSERT_TRUE(Comes(LobbyState::kGoodbye));
  ASSERT_TRUE(Comes(LobbyState::kWaiting));
  EXPECT_GT(loudest_db_, kHeard_db) << "the good-bye was heard";
  ASSERT_TRUE(Comes(LobbyState::kAsleep));
}

}  // namespace
}  // namespace kaori::test
