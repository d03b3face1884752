// The keys of Stream Decks, by their twin: what they call, what they show of it, and what goes wrong there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/appliance/programs/input_deck_fixture.h"

namespace kaori::input {
namespace {

using board::SourceState;
using std::chrono::milliseconds;
using ::testing::HasSubstr;
using Kind = sim::StreamDeck::Kind;

TEST_F(Decks, AKeyShowsWhatItCallsAndIsBrightWhileThatIsOn) {
  sim::StreamDeck deck(Kind::kMk2);
  PlugAndPlay(deck);
  ExpectGrey(deck, 2, 60);
  ExpectGrey(deck, 3, 0);
  Light(1U << 2U);
  Play(milliseconds(50));
  ExpectGrey(deck, 2, 180);
  Light(0);
  Play(milliseconds(50));
  ExpectGrey(deck, 2, 60);
  EXPECT_EQ(deck.wrong_pages() + deck.wrong_pictures(), 0);
}

class EveryDeck : public Decks, public ::testing::WithParamInterface<Kind> {};
INSTANTIATE_TEST_SUITE_P(All, EveryDeck, ::testing::Values(Kind::kMk2, Kind::kXl, Kind::kPlus, Kind::kMini));

TEST_P(EveryDeck, ItsLastKeyIsTheButtonOfThatNumber) {
  sim::StreamDeck deck(GetParam());
  PlugAndPlay(deck);
  const auto last = static_cast<unsigned>(deck.keys() - 1);
  deck.Push(deck.keys() - 1);
  Play(milliseconds(10));
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << last);
  deck.Release(deck.keys() - 1);
  Play(milliseconds(10));
  EXPECT_EQ(Board().surface.value.pushes[last], 1U);
  EXPECT_EQ(Board().surface.value.buttons_down, 0U);
}

TEST_F(Decks, PicturesThatTheShowBringsGoBeforeThoseOfTheImage) {
  for (SurfaceMap& map : maps_) map.pictures_of_show = file_.folder() / "of-the-show";
  std::filesystem::create_directories(file_.folder() / "of-the-show/72");
  std::ofstream(file_.folder() / fmt::format("of-the-show/72/{:016x}.jpg", kSmile), std::ios::binary)
      << GreyJpeg(72, 30);
  sim::StreamDeck deck(Kind::kMk2);
  PlugAndPlay(deck);
  ExpectGrey(deck, 2, 30);
  ExpectGrey(deck, 3, 0);
  show_now_.Write({.sheet = 1}, clock_.now(), SourceState::kLive);
  Play(milliseconds(50));
  ExpectGrey(deck, 2, 90);
}

TEST_F(Decks, KeysChangeTheirPicturesWithTheSheet) {
  sim::StreamDeck deck(Kind::kMk2);
  PlugAndPlay(deck);
  show_now_.Write({.sheet = 1}, clock_.now(), SourceState::kLive);
  Play(milliseconds(50));
  ExpectGrey(deck, 2, 90);
}

TEST_F(Decks, KeysFollowTheMapOfTheirButtons) {
  for (SurfaceMap& map : maps_)
    if (map.name == "Elgato Stream Deck") map.buttons[0] = 2, map.buttons[2].reset();
  sim::StreamDeck deck(Kind::kMk2);
  PlugAndPlay(deck);
  ExpectGrey(deck, 0, 60);
  ExpectGrey(deck, 2, 0);
  deck.Push(0);
  Play(milliseconds(10));
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 2U);
}

TEST_F(Decks, APictureOfOnesOwnForAKeyGoesBefore) {
  Put("3.jpg", GreyJpeg(72, 240));
  sim::StreamDeck deck(Kind::kMk2);
  PlugAndPlay(deck);
  ExpectGrey(deck, 2, 240);
}

TEST_F(Decks, AMiniIsSentBitmaps) {
  sim::StreamDeck mini(Kind::kMini);
  PlugAndPlay(mini);
  Play(milliseconds(400));
  ExpectGrey(mini, 2, 60);
  mini.Push(5);
  Light(1U << 2U);
  Play(milliseconds(200));
  ExpectGrey(mini, 2, 180);
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 5U);
  EXPECT_EQ(mini.wrong_pages() + mini.wrong_pictures(), 0);
}

TEST_F(Decks, PulledInMidPictureAllOfThemComeAgain) {
  sim::StreamDeck deck(Kind::kMk2);
  PlugIn("deck", deck);
  Start();
  Play(milliseconds(3));
  cables_[0]->Unplug();
  Play(milliseconds(20));
  EXPECT_FALSE(deck.picture(2));
  ASSERT_TRUE(cables_[0]->Plug());
  Play(milliseconds(400));
  ExpectGrey(deck, 2, 60);
  EXPECT_EQ(deck.wrong_pages(), 0);
}

TEST_F(Decks, ATornReportIsOneLineAndTheNextOneCounts) {
  sim::StreamDeck deck(Kind::kMk2);
  PlugAndPlay(deck);
  ::testing::internal::CaptureStderr();
  for (int n = 0; n < 3; ++n) {
    deck.TearNext();
    deck.Push(7);
    Play(milliseconds(5));
    EXPECT_EQ(Board().surface.value.buttons_down, 0U);
  }
  deck.Push(8);
  Play(milliseconds(5));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(LinesIn(said), 1) << said;
  EXPECT_THAT(said, HasSubstr("Bad message; further such reports are ignored silently"));
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 7U | 1U << 8U);
}

TEST_F(Decks, ATurnedDialOfADeckPushesNoKey) {
  sim::StreamDeck plus(Kind::kPlus);
  PlugAndPlay(plus);
  plus.TurnDial(0, 1);
  plus.TurnDial(3, -2);
  Play(milliseconds(10));
  EXPECT_EQ(Board().surface.value.buttons_down, 0U);
  plus.Push(7);
  Play(milliseconds(10));
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 7U);
}

TEST_F(Decks, AFileThatIsTooLargeForAKeyIsNamedOnceHoweverOftenItIsWanted) {
  Put(fmt::format("72/{:016x}-lit.jpg", kSmile), std::string(100'000, 'x'));
  sim::StreamDeck deck(Kind::kMk2);
  ::testing::internal::CaptureStderr();
  PlugAndPlay(deck);
  for (int n = 0; n < 6; ++n) {
    Light(n % 2 == 0 ? 1U << 2U : 0);
    Play(milliseconds(50));
  }
  const std::string said = ::testing::internal::GetCapturedStderr();
  const std::string name = fmt::format("{:016x}-lit.jpg", kSmile);
  EXPECT_THAT(said, HasSubstr(name));
  EXPECT_EQ(said.find(name), said.rfind(name)) << said;
  ExpectGrey(deck, 2, 60);
}

}  // namespace
}  // namespace kaori::input
