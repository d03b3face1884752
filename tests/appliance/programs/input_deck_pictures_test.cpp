// Pictures on the keys of a deck that is slow, refuses them, or fails in the middle of one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "appliance/programs/input/deck_pictures.h"
#include "tests/appliance/programs/input_deck_fixture.h"

namespace kaori::input {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A deck that answers as a test says.
class FakeDeck final : public ports::HidChannel {
 public:
  int pollable() const override { return -1; }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t>) override {
    return Fail(std::errc::resource_unavailable_try_again, "read");
  }
  Result<void> Write(std::span<const std::uint8_t> report) override {
    auto answered = answer(++writes, report);
    if (answered) pages.emplace_back(report.begin(), report.end());
    return answered;
  }

  using Page = std::span<const std::uint8_t>;
  std::function<Result<void>(int, Page)> answer = [](int, Page) { return Result<void>{}; };
  int writes = 0;
  std::vector<std::vector<std::uint8_t>> pages;

 private:
  ports::HidIdentity identity_{.port = "1-4", .name = "deck", .descriptor = {}};
};

class OneDeck : public Decks {
 protected:
  OneDeck() { shown_.Plug(decode::StreamDeckOf(0x0FD9, 0x0080), pictures()); }
  std::string Show(Duration time) {
    ::testing::internal::CaptureStderr();
    for (Duration t{}; t < time; t += milliseconds(5)) {
      clock_.Advance(milliseconds(5));
      shown_.Show(keys_, clock_.now(), channel_, "deck");
    }
    return ::testing::internal::GetCapturedStderr();
  }

  DeckPictures shown_;
  DeckPictures::Keys keys_{};
  FakeDeck channel_;
};

TEST_F(OneDeck, ThatIsSlowIsOneLineAndGetsItsPicturesAllTheSame) {
  const auto busy = [](int n, FakeDeck::Page) {
    return n % 500 == 0 ? Result<void>{}
                        : Result<void>(Fail(std::errc::resource_unavailable_try_again, "write"));
  };
  channel_.answer = busy;
  const std::string said = Show(std::chrono::seconds(60));
  EXPECT_EQ(LinesIn(said), 1) << said;
  EXPECT_THAT(said, HasSubstr("the deck at 1-4 takes its pictures slowly"));
  EXPECT_GE(channel_.pages.size(), 15U);
}

TEST_F(OneDeck, ThatRefusesPicturesIsTriedThreeTimesAndIsOneLine) {
  channel_.answer = [](int, FakeDeck::Page) { return Fail(std::errc::io_error, "write to the deck"); };
  const std::string said = Show(std::chrono::seconds(60));
  EXPECT_EQ(LinesIn(said), 1) << said;
  EXPECT_THAT(said, HasSubstr("its keys stay as they are until it is plugged in again"));
  EXPECT_EQ(channel_.writes, 3);
}

TEST_F(OneDeck, ThatRefusesAPageEachMinuteShowsAllPicturesAllTheSame) {
  bool refuses = false;
  channel_.answer = [&](int, FakeDeck::Page) {
    return std::exchange(refuses, false) ? Result<void>(Fail(std::errc::io_error, "write")) : Result<void>{};
  };
  for (int minute = 0; minute < 5; ++minute) {
    const auto before = channel_.pages.size();
    keys_[0] = {kSmile, minute % 2 == 0};
    refuses = true;
    EXPECT_THAT(Show(std::chrono::seconds(60)), IsEmpty());
    EXPECT_GT(channel_.pages.size(), before) << "in minute " << minute;
  }
}

TEST_F(OneDeck, APageThatFailedBeginsItsPictureAnew) {
  keys_[0] = {kSmile, false};
  Put(fmt::format("72/{:016x}.jpg", kSmile), std::string(3000, 'x'));
  bool failed = false;
  channel_.answer = [&](int, FakeDeck::Page page) {
    if (page[2] != 0 || page[6] != 1 || std::exchange(failed, true)) return Result<void>{};
    return Result<void>(Fail(std::errc::io_error, "write"));
  };
  EXPECT_THAT(Show(std::chrono::seconds(6)), IsEmpty());
  std::vector<int> of_key;
  for (const auto& page : channel_.pages)
    if (page[2] == 0) of_key.push_back(page[6]);
  EXPECT_THAT(of_key, ::testing::ElementsAre(0, 0, 1, 2)) << "half a picture is never gone on with";
}

TEST_F(OneDeck, AKeyThatBlinksLeavesTheOthersTheirTurn) {
  for (int n = 0; n < 40; ++n) {
    keys_[0] = {kSmile, n % 2 == 0};
    static_cast<void>(Show(milliseconds(5)));
  }
  std::set<int> keys;
  for (const auto& page : channel_.pages) keys.insert(page[2]);
  EXPECT_EQ(keys.size(), 15U);
}

}  // namespace
}  // namespace kaori::input
