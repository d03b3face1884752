// Bad shows: each is refused by its own words, and what played stays chosen.
#include <gmock/gmock.h>

#include <set>

#include "tests/appliance/programs/shows_simulated_folder.h"

namespace kaori::shows {
namespace {

using ::testing::HasSubstr;

class BadShow : public InstallationTest {
 protected:
  BadShow() {
    Install(folder_, first_);
    before_ = folder_.Names().value();
  }
  // Installs what must be refused, and gives the words; checks that nothing has changed.
  Message Refused(std::unique_ptr<Source> source, const Trial& trial = {}) {
    const Progress progress = Install(folder_, std::move(source), trial);
    EXPECT_TRUE(IsRefusal(progress.message)) << Words(progress.message, Language::kEnglish);
    EXPECT_EQ(ReadChoice(folder_).current, IdOf(first_));
    EXPECT_EQ(folder_.Names().value(), before_) << "nothing stays behind";
    return progress.message;
  }
  Message Refused(Bytes pack) { return Refused(std::make_unique<SimulatedSource>(std::move(pack))); }
  Bytes With(std::size_t at, std::uint8_t value) const {
    Bytes pack = second_;
    pack[at] = value;
    return pack;
  }

  SimulatedFolder folder_;
  std::vector<std::string> before_;
};

TEST_F(BadShow, WithAFlippedBitAnywhereIsDamaged) {
  for (const std::size_t at : {std::size_t{60}, std::size_t{90}, std::size_t{200}, second_.size() - 1})
    EXPECT_EQ(Refused(With(at, static_cast<std::uint8_t>(second_[at] ^ 4U))), Message::kDamaged) << at;
}

TEST_F(BadShow, ThatIsCutOffIsNamedSo) {
  for (const std::size_t length : {std::size_t{100}, std::size_t{193}, second_.size() - 1})
    EXPECT_EQ(Refused(Bytes(second_.begin(), second_.begin() + static_cast<std::ptrdiff_t>(length))),
              Message::kCutOff);
}

TEST_F(BadShow, OfNobodyOrOfAnotherSignerIsNamedSo) {
  EXPECT_EQ(Refused(PackOf("evening", nullptr)), Message::kUnsigned);
  const auto other = show::MakeKey().value();
  EXPECT_EQ(Refused(PackOf("evening", &other)), Message::kForeign);
  keys_.clear();
  EXPECT_EQ(Refused(second_), Message::kNoKeys);
}

TEST_F(BadShow, OfAnotherFormatIsNamedSo) {
  EXPECT_EQ(Refused(With(8, 3)), Message::kNewerFormat);
  EXPECT_EQ(Refused(With(8, 1)), Message::kOlderFormat);
  EXPECT_EQ(Refused(Bytes(5000, 'x')), Message::kNotAShow);
  EXPECT_EQ(Refused(Bytes()), Message::kNotAShow);
}

TEST_F(BadShow, ThatIsTooLargeIsRefusedBeforeItIsCopied) {
  EXPECT_EQ(Refused(std::make_unique<SimulatedSource>(second_, std::nullopt, std::uint64_t{3} << 30U)),
            Message::kTooLarge);
}

TEST_F(BadShow, OnAStickThatIsPulledIsNamedSoWhereverThatHappens) {
  for (std::size_t at = 0; at < second_.size(); at += second_.size() / 7)
    EXPECT_EQ(Refused(std::make_unique<SimulatedSource>(second_, at)), Message::kPulled) << at;
  Bytes shorter(second_.begin(), second_.end() - 1000);
  EXPECT_EQ(Refused(std::make_unique<SimulatedSource>(shorter, std::nullopt, second_.size())),
            Message::kPulled);
}

TEST_F(BadShow, ThatDoesNotFitIsRefusedAndSaysHowMuchRoomItWants) {
  folder_.capacity_bytes = first_.size() + second_.size();  // The reserve is missing.
  EXPECT_EQ(Refused(second_), Message::kFull);
  Installation once(folder_, std::make_unique<SimulatedSource>(second_), keys_, {});
  EXPECT_THAT(once.Step().detail, HasSubstr(" MB are needed"));
}

TEST_F(BadShow, ThatDoesNotPlayIsRefusedWithItsReason) {
  const Trial trial = [](const auto& pack) -> Result<void> {
    return FailInput(pack.filename().string() + " is black");
  };
  EXPECT_EQ(Refused(std::make_unique<SimulatedSource>(second_), trial), Message::kUnplayable);
}

TEST_F(BadShow, IsTriedUnderItsFinalContent) {
  Bytes tried;
  const Trial trial = [&](const std::filesystem::path& pack) -> Result<void> {
    tried = folder_.Content(pack.filename());
    return {};
  };
  EXPECT_EQ(Install(folder_, std::make_unique<SimulatedSource>(second_), trial).message, Message::kInstalled);
  EXPECT_EQ(tried, second_);
}

TEST_F(BadShow, LeavesRoomForGoodOnesByGivingUpWhatNobodyPlays) {
  const Bytes third = PackOf("gala", &company_);
  EXPECT_EQ(Install(folder_, second_).message, Message::kInstalled);
  folder_.capacity_bytes =
      first_.size() + second_.size() + third.size() + Installation::kReserve_bytes + 2000;
  EXPECT_EQ(Install(folder_, third).message, Message::kInstalled);
  EXPECT_EQ(Install(folder_, PackOf("last", &company_)).message, Message::kInstalled);
  EXPECT_EQ(folder_.Content(store::PackName(IdOf(first_))), Bytes()) << "nobody plays it any more";
  EXPECT_EQ(ReadChoice(folder_).previous, IdOf(third));
  EXPECT_EQ(folder_.Content(store::PackName(IdOf(third))), third);
}

// A small disk holds two shows: the third takes the place of the one before, never of the one that plays.
TEST_F(BadShow, TheOneThatWasPlayedBeforeGoesWhereThereIsNoOtherRoom) {
  const Bytes third = PackOf("gala", &company_);
  Install(folder_, second_);
  folder_.capacity_bytes = first_.size() + second_.size() + Installation::kReserve_bytes + 2000;
  EXPECT_EQ(Install(folder_, third).message, Message::kInstalled);
  EXPECT_EQ(ReadChoice(folder_), (store::Choice{3, IdOf(third), IdOf(second_)}));
  EXPECT_EQ(folder_.Content(store::PackName(IdOf(second_))), second_);
}

TEST_F(BadShow, NothingGoesForOneThatWouldNotFitAllTheSame) {
  Install(folder_, second_);
  folder_.capacity_bytes = first_.size() + second_.size() + 2000;
  const auto before = folder_.Names().value();
  EXPECT_EQ(Install(folder_, PackOf("gala", &company_)).message, Message::kFull);
  EXPECT_EQ(folder_.Names().value(), before);
}

// The chosen one gave way: what plays is kept, and is what the new one falls back to.
TEST_F(BadShow, WhatPlaysIsKeptThoughAnotherOneIsChosen) {
  Install(folder_, second_);
  const Bytes third = PackOf("gala", &company_);
  folder_.capacity_bytes =
      first_.size() + second_.size() + third.size() + Installation::kReserve_bytes + 2000;
  Installation installation(folder_, std::make_unique<SimulatedSource>(third), keys_,
                            [](const auto&) -> Result<void> { return {}; }, {.plays = IdOf(first_)});
  while (!installation.ended()) installation.Step();
  EXPECT_EQ(ReadChoice(folder_), (store::Choice{3, IdOf(third), IdOf(first_)}));
}

// The key is turned back while the chosen show is looked at once more: it is whole, and no room is made of it.
TEST_F(BadShow, TheOneThatPlaysIsNotRemovedWhereTheKeyIsTurnedBackWhileItIsLookedAt) {
  folder_.capacity_bytes = first_.size() + Installation::kReserve_bytes + 2000;
  const Trial trial = [](const auto&) -> Result<void> {
    return Fail(std::errc::operation_canceled, "rehearse the show");
  };
  const Progress progress =
      Install(folder_, std::make_unique<SimulatedSource>(first_, std::size_t{1000}), trial);
  EXPECT_EQ(progress.message, Message::kKeyOff);
  EXPECT_EQ(folder_.Content(store::PackName(IdOf(first_))), first_);
}

// The chosen one gave way, and the one that plays is taken again from a stick that is pulled.
TEST_F(BadShow, TheOneThatPlaysInPlaceOfTheChosenOneIsNotRemovedForACopyOfItself) {
  Install(folder_, second_);
  folder_.capacity_bytes = first_.size() + second_.size() + Installation::kReserve_bytes + 2000;
  Installation installation(folder_, std::make_unique<SimulatedSource>(first_, std::size_t{1000}), keys_,
                            [](const auto&) -> Result<void> { return {}; }, {.plays = IdOf(first_)});
  while (!installation.ended()) installation.Step();
  EXPECT_EQ(folder_.Content(store::PackName(IdOf(first_))), first_) << "it plays";
  EXPECT_EQ(ReadChoice(folder_), (store::Choice{3, IdOf(first_), std::string(store::kRootShow)}));
}

TEST_F(BadShow, IsNotBlamedWhereTheKeyIsTurnedBackInItsTrial) {
  const Trial trial = [](const auto&) -> Result<void> {
    return Fail(std::errc::operation_canceled, "rehearse the show");
  };
  EXPECT_EQ(Refused(std::make_unique<SimulatedSource>(second_), trial), Message::kKeyOff);
}

TEST_F(BadShow, OfWhichHalfACopyIsLeftTakesNoRoomAfterTheNextStart) {
  {
    Installation installation(folder_, std::make_unique<SimulatedSource>(second_), keys_, {});
    installation.Step();
    installation.Step();
  }
  EXPECT_NE(folder_.Names().value(), before_);
  RemoveLeftovers(folder_);
  EXPECT_EQ(folder_.Names().value(), before_);
}

TEST_F(BadShow, TheOneThatPlaysNeedsNoSecondCopy) {
  EXPECT_EQ(Install(folder_, first_).message, Message::kAlreadyThere);
  EXPECT_FALSE(IsRefusal(Message::kAlreadyThere));
}

TEST_F(BadShow, TheChosenOneIsCopiedAnewWhereTheDiskHasSpoiltItAndTheOneBeforeStays) {
  Install(folder_, second_);
  auto& spoilt = folder_.ContentOf(store::PackName(IdOf(second_)));
  spoilt[second_.size() / 2] ^= 1U;
  folder_.capacity_bytes = first_.size() + second_.size() + Installation::kReserve_bytes + 2000;
  const Trial trial = [&](const std::filesystem::path& pack) -> Result<void> {
    if (folder_.Content(pack.filename()) == second_) return {};
    return FailInput("its checksum does not fit");
  };
  EXPECT_EQ(Install(folder_, std::make_unique<SimulatedSource>(second_), trial).message, Message::kInstalled);
  EXPECT_EQ(folder_.Content(store::PackName(IdOf(second_))), second_);
  EXPECT_EQ(ReadChoice(folder_), (store::Choice{3, IdOf(second_), IdOf(first_)}));
}

// Nobody is left without words, in either language, and no two faults share theirs.
TEST(Messages, AreSaidInTwoLanguagesAndAreAllDifferent) {
  std::set<std::string_view> english, japanese;
  for (std::size_t i = 0; i < kMessageCount; ++i) {
    english.insert(Words(static_cast<Message>(i), Language::kEnglish));
    japanese.insert(Words(static_cast<Message>(i), Language::kJapanese));
    EXPECT_GE(static_cast<unsigned char>(Words(static_cast<Message>(i), Language::kJapanese).front()), 0x80U)
        << i;
  }
  EXPECT_EQ(english.size(), kMessageCount);
  EXPECT_EQ(japanese.size(), kMessageCount);
  EXPECT_EQ(english.count(""), 0U);
  EXPECT_EQ(Say(Message::kFull, Language::kEnglish, "evening", "9 MB are needed"),
            "evening: there is no room on the box (9 MB are needed)");
}

}  // namespace
}  // namespace kaori::shows
