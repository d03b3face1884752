// The sixty-second play by simulated devices, through report bytes and camera frames, to pictures that people
// have looked at.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/checksum.h"
#include "hw-sim/rehearsal/rehearsal.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"
#include "tests/golden/compare.h"

namespace kaori::golden {
namespace {

constexpr const char* kPlay = KAORI_PLAYS "/kaori.play";
constexpr double kHz = 12;
// Seconds into the play: her hair as she becomes the poster, the poster, its turn into the narrator, his prologue, the wire
// neck in the dark, the four styles and their fades, the expressions, hair and neck on the way to the kettle, the kettle, the
// dog between two faces, hair and clothes as the dog leaves, the farewell.
constexpr std::array<double, 24> kMoments_s{0.8,  1.9,  4.2,  6.9,  9.5,  12.5, 16.5, 18.4,
                                            19.6, 21.3, 23.0, 26.0, 28.4, 33.0, 36.6, 37.6,
                                            37.8, 39.8, 42.9, 44.1, 47.6, 48.1, 52.5, 57.0};

image::Picture ToPicture(const sim::Shown& shown) {
  return {shown.width_px, shown.height_px, {shown.rgbx.begin(), shown.rgbx.end()}};
}

// One rehearsal of the play.
class PlayTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto show = show::LoadPack(KAORI_PACK);
    ASSERT_TRUE(show) << show.error().message();
    auto studio = stage::Studio::Open(std::move(*show));
    ASSERT_TRUE(studio) << studio.error().message();
    studio_ = std::move(*studio);
  }
  static void TearDownTestSuite() { studio_.reset(); }

  PlayTest() : folder_(std::filesystem::temp_directory_path() / fmt::format("kaori-play-{}", ::getpid())) {}
  ~PlayTest() override { std::filesystem::remove_all(folder_); }

  void Open(int width_px, int height_px) {
    auto scenario = sim::LoadScenario(kPlay);
    ASSERT_TRUE(scenario) << scenario.error().attempt;
    auto rehearsal = sim::Rehearsal::Open(
        {.folder = folder_, .width_px = width_px, .height_px = height_px, .hz = kHz}, *studio_);
    ASSERT_TRUE(rehearsal) << rehearsal.error().message();
    rehearsal_ = std::move(*rehearsal);
    player_ = std::make_unique<sim::Player>(std::move(*scenario), rehearsal_->rig(), rehearsal_->began());
  }

  sim::Shown Next() {
    auto shown = rehearsal_->NextPicture([this](Time now) { player_->Perform(now); });
    EXPECT_TRUE(shown) << shown.error().message();
    return shown.value_or(sim::Shown{});
  }

  static std::unique_ptr<stage::Studio> studio_;
  std::filesystem::path folder_;
  std::unique_ptr<sim::Rehearsal> rehearsal_;
  std::unique_ptr<sim::Player> player_;
};
std::unique_ptr<stage::Studio> PlayTest::studio_;

TEST_F(PlayTest, LooksAsItDidWhenItWasAccepted) {
  Open(480, 270);
  std::size_t moment = 0;
  while (moment < kMoments_s.size() && !HasFatalFailure()) {
    const sim::Shown shown = Next();
    ASSERT_FALSE(shown.rgbx.empty());
    if (Seconds(player_->position()) < kMoments_s[moment]) continue;
    EXPECT_EQ(Compare(ToPicture(shown), fmt::format("play-{:04.1f}", kMoments_s[moment])), "");
    ++moment;
  }
}

// What a run leaves behind, to be compared with another run.
struct Trace {
  std::vector<std::uint64_t> boards;
  std::vector<std::uint64_t> pictures;
  friend bool operator==(const Trace&, const Trace&) = default;
};

template <class T>
std::uint64_t HashOf(const T& value) {
  return Fnv1a(std::span(reinterpret_cast<const std::uint8_t*>(&value), sizeof(value)));
}

TEST_F(PlayTest, TheSameScenarioGivesTheSameBoardAndTheSamePictures) {
  std::array<Trace, 2> traces;
  for (Trace& trace : traces) {
    Open(160, 90);
    ASSERT_FALSE(HasFatalFailure());
    while (player_->position() < std::chrono::seconds(20)) {
      trace.pictures.push_back(Fnv1a(Next().rgbx));
      const auto board = board::ReadAll(rehearsal_->board());
      trace.boards.push_back(HashOf(board.surface.value) ^ HashOf(board.sticks[0].value) ^
                             HashOf(board.keys.value) ^ HashOf(board.lips.value) ^ HashOf(board.lamps.value));
    }
    rehearsal_.reset();
  }
  EXPECT_GT(traces[0].pictures.size(), 200U);
  EXPECT_NE(traces[0].pictures.front(), traces[0].pictures.back()) << "nothing was played";
  EXPECT_EQ(traces[0], traces[1]);
}

TEST_F(PlayTest, AHandOnADialIsSeenInThePicture) {
  Open(160, 90);
  ASSERT_FALSE(HasFatalFailure());
  rehearsal_->rig().dial_box().Turn(6, -1);  // Life off: the face holds still.
  for (int i = 0; i < 20; ++i) Next();
  const auto before = Fnv1a(Next().rgbx);
  EXPECT_EQ(Fnv1a(Next().rgbx), before) << "a still face is drawn the same";
  rehearsal_->rig().dial_box().Turn(4, 0.5);  // The mouth opens.
  Next();
  Next();
  EXPECT_NE(Fnv1a(Next().rgbx), before);
}

}  // namespace
}  // namespace kaori::golden
