// The show log: a whole evening plays again to the bit, and what is torn is named and left out.
#include <gmock/gmock.h>

#include <cstring>
#include <random>
#include <span>

#include "appliance/core/board/lines.h"
#include "appliance/core/performance/levels.h"
#include "drivers/base/checksum.h"
#include "firmware/wire/bytes.h"
#include "hw-sim/evening/allocations.h"
#include "tests/appliance/core/showlog_fixture.h"

namespace kaori::showlog {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The numbers of a frame that a person sees, as bytes.
std::uint16_t Bits(const scene::Scene& scene) {
  return OutputSum({{}, scene, 0});
}

TEST(ShowLogChange, OfAnyWordsIsReadBackAndNeverReachesBeyondTheLastWord) {
  std::mt19937 chance(3);
  std::vector<std::uint32_t> before(5003), now(before.size());
  for (int round = 0; round < 200; ++round) {
    for (std::size_t i = 0; i < now.size(); ++i)
      if (chance() % (1U + chance() % 3000U) == 0)
        now[i] = static_cast<std::uint32_t>(chance() >> chance() % 32);
    std::vector<std::uint8_t> bytes(MostChange_bytes(now.size()));
    const std::size_t length = WriteChange(before, now, bytes);
    ASSERT_LE(length, bytes.size());
    std::vector<std::uint32_t> read = before;
    ASSERT_EQ(ReadChange(std::span(bytes).first(length), read), length);
    ASSERT_EQ(read, now);
    for (std::size_t cut = 0; cut < length; cut += 1 + chance() % 50)
      ASSERT_FALSE(ReadChange(std::span(bytes).first(cut), read)) << cut << " of " << length;
    bytes[chance() % length] ^= static_cast<std::uint8_t>(1U << chance() % 8);
    (void)ReadChange(std::span(bytes).first(length), read);  // Anything but a fault of memory.
    before = now;
  }
}

TEST_F(ShowLogTest, PlaysAgainToTheBit) {
  Play(60 * 95);  // More than three chunks.
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_EQ(log->chunks().size(), 4U);
  EXPECT_THAT(log->faults(), ElementsAre());
  Replay replay(*log, show_);
  std::size_t frame = 0, differ = 0;
  for (; replay.Next(); ++frame) {
    ASSERT_LT(frame, shown_.size());
    if (Bits(replay.made().scene) != Bits(shown_[frame]) || !replay.same()) ++differ;
    EXPECT_EQ(replay.follows(), frame > 0);
  }
  EXPECT_EQ(frame, shown_.size());
  EXPECT_EQ(differ, 0U);
  // Bits and not numbers. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  EXPECT_EQ(std::memcmp(&replay.made().state.levels, &state_.levels, sizeof(state_.levels)), 0);
  RecordProperty("replay_bits_differ", static_cast<int>(differ));
}

TEST_F(ShowLogTest, PlaysTogglesHeldButtonsAndTheSecondSheetAgainToTheBit) {
  show_.buttons[26] = {show::CallKind::kExpression, 4, show::CallMode::kToggle};
  show_.buttons[27] = {show::CallKind::kFace, 2, show::CallMode::kMomentary};
  show_.buttons[28] = {show::CallKind::kSheet, 1, show::CallMode::kMomentary};
  show_.second_buttons[29] = {show::CallKind::kExpression, 6, show::CallMode::kToggle};
  show_.expression_fades.resize(7);
  show_.expression_fades[4] = {.in_s = 0.4F, .out_s = 90, .curve = show::FadeCurve::kSlowEnd};
  show_.roles.mixes = {{show::CallKind::kExpression, 8}};
  show_.roles.roles[0].maps.push_back({.control = show::Control::kDial, .level = show::MixLevel(0), .to = 1});
  performance::BeginLevels(state_, show_.roles);
  int kept = 0;
  for (int k = 0; k < 120; ++k) {  // Two chunks, and a part of the third.
    board_.surface.value.buttons_down = static_cast<std::uint32_t>(k) % 8 << 26U;
    for (int button = 26; button < 30; ++button)
      if ((k + button) % 3 == 0) Push(button);
    Play(37);
    kept += state_.kept[1].call.kind != show::CallKind::kNothing ? 1 : 0;
  }
  EXPECT_GT(kept, 20) << "something was kept";
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  Replay whole(*log, show_);
  while (whole.Next()) {
  }
  EXPECT_EQ(whole.frames(), shown_.size());
  EXPECT_EQ(whole.frames_that_differ(), 0U);
  Replay later(*log, show_);
  later.GoTo(log->chunks()[1].head.first);
  while (later.Next()) {
  }
  EXPECT_GT(later.frames(), 1000U);
  EXPECT_EQ(later.frames_that_differ(), 0U) << "from the state that the chunk holds";
}

// What the lobby does follows from the sensor and from what the wall clock said, and both are in the log.
TEST_F(ShowLogTest, PlaysAnEveningInTheLobbyAgainToTheBit) {
  show_.gaze_targets = {{show::kHouseName, {0, 0, 4}}};
  show::Track(show_);
  show_.lobby =
      show::Lobby{.cue = 0, .by_itself = true, .greetings = {{"en", 0}}, .sleep_s = 3, .hours = {{0, 60}}};
  board_.lines.source = board::SourceState::kLive;
  still_ = true;
  week_minute_ = [this] { return frame_ < 2000 ? 59 : 60; };
  std::array<int, performance::kLobbyPhaseCount> frames{};
  for (int k = 0; k < 60; ++k) {
    board_.lines.value.active = k % 20 > 10 ? 1U << static_cast<unsigned>(board::Line::kPresence) : 0U;
    Play(50);
    ++frames[static_cast<std::size_t>(state_.lobby.phase)];
  }
  EXPECT_GT(frames[static_cast<std::size_t>(performance::LobbyPhase::kAsleep)], 10);
  EXPECT_GT(frames[static_cast<std::size_t>(performance::LobbyPhase::kWith)], 5);
  EXPECT_EQ(state_.lobby.week_minute, 60);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  Replay replay(*log, show_);
  while (replay.Next()) {
  }
  EXPECT_EQ(replay.frames(), shown_.size());
  EXPECT_EQ(replay.frames_that_differ(), 0U);
  // Bits and not numbers. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  EXPECT_EQ(std::memcmp(&replay.made().state.lobby, &state_.lobby, sizeof(state_.lobby)), 0);
}

TEST_F(ShowLogTest, SaysWhereAnotherShowPlaysOtherwise) {
  Play(600);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  show_.motions[0].curves[0].keys[1].value = -0.2001F;  // A nod that is a hundredth of a degree deeper.
  Replay replay(*log, show_);
  while (replay.Next()) {
  }
  EXPECT_GT(replay.frames_that_differ(), 10U);
  EXPECT_LT(replay.frames_that_differ(), replay.frames())
      << "hair swings on for a while, but not before the nod";
  ASSERT_TRUE(replay.first_difference());
}

TEST_F(ShowLogTest, BeginsInTheMiddleWhereItIsAskedTo) {
  Play(60 * 70);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_EQ(log->Day(), "2024-10-04");
  EXPECT_EQ(log->DayTimeText(log->chunks()[0].head.first), "19:00:00");
  const auto at = log->AtDayTime("19:00:45");
  ASSERT_TRUE(at);
  EXPECT_FALSE(log->AtDayTime("19:00:45 or so"));
  EXPECT_FALSE(log->AtDayTime("25:00"));
  Replay replay(*log, show_);
  replay.GoTo(*at);
  ASSERT_TRUE(replay.Next());
  EXPECT_EQ(log->DayTimeText(replay.presented_at()), "19:00:30") << "the chunk in which it lies";
  const std::size_t skipped = log->chunks()[0].head.frames;
  EXPECT_EQ(Bits(replay.made().scene), Bits(shown_[skipped]));
  while (replay.Next()) {
  }
  EXPECT_EQ(replay.frames_that_differ(), 0U);
  EXPECT_EQ(replay.frames(), shown_.size() - skipped);
}

TEST_F(ShowLogTest, KeepsWhatAnEditorChangedBetweenTwoFrames) {
  Play(100);
  state_.expressions.to = 7;
  Play(1, /*changed=*/true);
  Play(100);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  Replay replay(*log, show_);
  while (replay.Next()) {
  }
  EXPECT_EQ(replay.frames_that_differ(), 0U);
}

TEST_F(ShowLogTest, SaysWhichBoxPlayedAndAHeadOfVersion1SaysNone) {
  head_.box = "left-lobby";
  head_.roles = "roles";
  const auto read = ReadHead(HeadBytes(head_));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->head.box, "left-lobby");
  EXPECT_EQ(read->head.roles, "roles");
  head_.box.assign(1000, 'a');
  EXPECT_EQ(ReadHead(HeadBytes(head_)).value().head.box.size(), kMostName_bytes);

  head_.box.clear();
  auto old = HeadBytes(head_);
  constexpr std::ptrdiff_t kNameLengthAt = 56, kLength = 4, kSum = 8;
  old.erase(old.begin() + kNameLengthAt, old.begin() + kNameLengthAt + kLength);
  wire::PutU32(old, 8, 1);
  wire::PutU32(old, 12, static_cast<std::uint32_t>(old.size()));
  const std::size_t sum_at = old.size() - kSum;
  wire::PutU64(old, sum_at, Fnv1a(std::span<const std::uint8_t>(old).first(sum_at)));
  const auto first = ReadHead(old);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->head.roles, "roles");
  EXPECT_EQ(first->head.show, head_.show);
  EXPECT_EQ(first->bytes, old.size());
}

TEST_F(ShowLogTest, ThatIsTornOrSpoiltIsNamedAndTheRestIsPlayed) {
  Play(60 * 95);
  ASSERT_TRUE(Read());
  const std::vector<std::uint8_t> whole = bytes_;
  const auto second = LogFile::Read(file_)->chunks()[1].at_byte;
  bytes_.resize(bytes_.size() - 3);
  auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_EQ(log->chunks().size(), 3U);
  EXPECT_THAT(log->faults(), ElementsAre(HasSubstr("are torn or spoilt, behind the part of 19:01:00")));

  bytes_ = whole;
  bytes_[second + 1000] ^= 4U;
  log = Read();
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_EQ(log->chunks().size(), 3U);
  ASSERT_EQ(log->faults().size(), 1U);
  EXPECT_THAT(log->faults()[0], HasSubstr(fmt::format("bytes {} to", second)));
  Replay replay(*log, show_);
  std::uint64_t gaps = 0;
  while (replay.Next()) gaps += replay.follows() ? 0 : 1;
  EXPECT_EQ(gaps, 2U) << "the beginning, and behind the spoilt part";
  EXPECT_EQ(replay.frames_that_differ(), 0U);
  EXPECT_GT(replay.frames(), 3000U);
}

TEST_F(ShowLogTest, OfWhichNothingCanBePlayedIsRefusedInOneLine) {
  Play(10);
  recorder_.Close();
  const std::vector<std::uint8_t> whole = bytes_;
  const auto said = [&] {
    const auto log = Read();
    return log ? std::string("it was read") : log.error().message();
  };
  bytes_.resize(40);
  EXPECT_THAT(said(), HasSubstr("the beginning of this show log is torn"));
  bytes_ = whole;
  bytes_[0] = 'X';
  EXPECT_THAT(said(), HasSubstr("this is no show log"));
  bytes_ = whole;
  bytes_.back() ^= 1U;
  EXPECT_THAT(said(), HasSubstr("no part of this show log is whole"));
  head_.layout ^= 1U;
  bytes_ = HeadBytes(head_);
  EXPECT_THAT(said(), HasSubstr("another version of the programs wrote this show log"));
}

TEST_F(ShowLogTest, SaysHowManyFramesASlowDiskHasCost) {
  write_ = false;
  Play(60 * 95);
  recorder_.Release();
  write_ = true;
  Play(60 * 5);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  ASSERT_EQ(log->chunks().size(), 2U);
  const std::size_t lost = log->chunks()[1].head.lost_frames;
  EXPECT_EQ(lost + log->chunks()[0].head.frames + log->chunks()[1].head.frames, shown_.size());
  EXPECT_THAT(log->faults(), ElementsAre(HasSubstr(fmt::format("{} frames before", lost))));
  Replay replay(*log, show_);
  while (replay.Next()) {
  }
  EXPECT_EQ(replay.frames_that_differ(), 0U);
}

TEST_F(ShowLogTest, TakesNothingFromTheHeapAndFewBytesForAMinute) {
  shown_.reserve(10'000);
  bytes_.reserve(std::size_t{8} << 20U);
  Play(10);
  const std::size_t before = sim::AllocationCount();
  Play(60 * 60);
  recorder_.Close();
  EXPECT_EQ(sim::AllocationCount() - before, 0U);
  const double minutes = (60 * 60 + 10) / 3600.0;
  const double kb_per_min = static_cast<double>(bytes_.size()) / 1000 / minutes;
  RecordProperty("log_kb_per_min", static_cast<int>(kb_per_min));
  EXPECT_LE(kb_per_min, 300);
  EXPECT_GT(kb_per_min, 50) << "everything moves: less would mean that something is left out";
}

}  // namespace
}  // namespace kaori::showlog
