// An author at work with the handles when the stage dies: nothing older than a second is lost.
#include <gmock/gmock.h>

#include <algorithm>
#include <deque>
#include <memory>

#include "appliance/core/board/performance_state.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/pack.h"
#include "appliance/programs/editor/journal.h"
#include "appliance/programs/editor/keys.h"
#include "hw-sim/links/local/rig.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;
namespace key = editor::key;

constexpr int kOutwards = 3;                     // The dial.
constexpr float kPullPerCount_m = 0.010F / 256;  // As docs/playing.md says.
constexpr Duration kNothingOlder = std::chrono::seconds(1);

class AnAuthorAtTheBox : public ::testing::Test {
 protected:
  AnAuthorAtTheBox() : board_(board::Board::Create(programs_.board()).value()) {
    rig_ = sim::Rig::Open({.folder = programs_.links(),
                           .screen_width_px = 160,
                           .screen_height_px = 90,
                           .screen_period = milliseconds(33)},
                          clock_)
               .value();
  }

  static std::string Pack() {
    return (ProgramRunner::Programs().parent_path() / "shows" / "kaori.kaori").string();
  }
  std::string Own() const { return programs_.File("own"); }

  void StartStage() {
    programs_.Start("kaori-stage", {"--links", programs_.links(), "--board", programs_.board(), "--pack",
                                    Pack(), "--own", Own()});
  }

  bool Between() {
    rig_->Pump();
    return true;
  }
  bool Until(const std::function<bool()>& condition) {
    return Await([&] { return Between() && condition(); }, std::chrono::seconds(30));
  }
  void Hold(Duration time) {
    const Time end = clock_.now() + time;
    Until([&] { return clock_.now() >= end; });
  }

  void Strike(std::uint8_t usage) {
    const auto presses = [&] { return board_.Read<board::Keys>().value.log.count; };
    const std::uint32_t before = presses();
    rig_->keyboard().Press(usage);
    ASSERT_TRUE(Until([&] { return presses() != before && Seen().key_presses == presses(); }));
    rig_->keyboard().Release(usage);
    ASSERT_TRUE(Until([&] { return !board::IsDown(board_.Read<board::Keys>().value, usage); }));
  }

  // What the stage has taken in.
  performance::SeenInput Seen() const {
    const auto state = board::Restore<performance::State>(board_.Read<board::Performance>().value);
    return state ? state->seen : performance::SeenInput{};
  }

  // How far the journal has the pulled handle, in counts of the dial.
  float PulledInJournal() const {
    const show::Show show = show::LoadPack(Pack()).value();
    editor::Session session(editor::PointsOf(show.cast.net));
    const auto opened =
        editor::Journal::Open(Own() + "/needles.journal", editor::Fingerprint(session.points()));
    EXPECT_TRUE(opened);
    for (const auto& record : opened->records) session.Replay(record.change, record.work);
    float most_m = 0;
    for (std::size_t i = 0; i < session.points().size(); ++i)
      most_m = std::max(most_m, session.work().pulls_m[i].z - session.before().pulls_m[i].z);
    return most_m / kPullPerCount_m;
  }

  SteadyClock clock_;
  ProgramRunner programs_;
  board::Board board_;
  std::unique_ptr<sim::Rig> rig_;
};

TEST_F(AnAuthorAtTheBox, LoseNothingOlderThanASecondWhenTheStageIsKilled) {
  programs_.Start("kaori-input", {"--links", programs_.links(), "--board", programs_.board()});
  StartStage();
  const auto frames = [&] { return board_.Read<board::StageStatus>().value.frames; };
  ASSERT_TRUE(Until([&] {
    return board_.Read<board::Keys>().source == board::SourceState::kLive &&
           board_.Read<board::Surface>().source == board::SourceState::kLive && frames() > 2;
  })) << programs_.LogOf("kaori-stage");
  Strike(key::kTab);
  // By the journal when the stage was killed last: what that took is gone, and the hand goes on from there.
  float kept = 0;
  for (int round = 0; round < 3; ++round) {
    const std::int32_t at_first = Seen().dials[kOutwards];
    std::deque<std::pair<Time, std::int32_t>> seen;  // When the stage had which count.
    // These times fall late between two writes of a journal that is written too seldom: of one that is written
    // each 1.25, 1.6 or 2.5 s, more than a second is missing at one of the kills.
    const Time end = clock_.now() + milliseconds(1900 + 450 * round);
    for (int turn = 0; clock_.now() < end; ++turn) {
      rig_->dial_box().Turn(kOutwards, 2.0 / 256);
      Hold(milliseconds(25));
      seen.emplace_back(clock_.now(), Seen().dials[kOutwards]);
    }
    const Time killed = clock_.now();
    programs_.Kill("kaori-stage");
    std::int32_t sure = 0;
    for (const auto& [at, count] : seen)
      if (killed - at > kNothingOlder) sure = count;
    ASSERT_GT(sure, seen.front().second) << "it turned before that second, too";
    const float pulled = PulledInJournal();
    EXPECT_GE(pulled + 0.01F, kept + static_cast<float>(sure - at_first)) << "round " << round;
    kept = pulled;
    StartStage();
    const std::uint32_t frames_then = frames();
    ASSERT_TRUE(Until([&] { return frames() > frames_then; })) << programs_.LogOf("kaori-stage");
    EXPECT_THAT(programs_.LogOf("kaori-stage"), HasSubstr("unsaved needle work is taken up again"));
    Strike(key::kTab);
  }
}

}  // namespace
}  // namespace kaori::test
