// Which show a stage plays, and what a rehearsal finds.
#include <gmock/gmock.h>

#include <fstream>

#include "appliance/core/show/pack_keys.h"
#include "appliance/programs/stage/chosen_show.h"
#include "appliance/programs/stage/rehearsal.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;

class ChosenShowTest : public tests::PackTest {
 protected:
  ChosenShowTest() {
    fs::create_directories(folder_ / "root/keys");
    fs::create_directories(folder_ / "shows");
    EXPECT_TRUE(SaveKey(company_, folder_ / "root/keys/company"));
    Put(folder_ / "root/kaori.kaori", "of the root", nullptr);
  }
  void Put(const fs::path& file, const std::string& name, const show::SecretKey* signer) const {
    show::Show show = tests::SmallShow();
    show.name = name;
    EXPECT_TRUE(show::SavePack(show, file, signer));
  }
  void PutShow(char id, const std::string& name, const show::SecretKey* signer) const {
    Put(folder_ / "shows" / store::PackName(std::string(64, id)), name, signer);
  }
  void Choose(std::uint64_t generation, char current, char previous) const {
    const std::string text =
        store::Format(store::Choice{generation, std::string(64, current), std::string(64, previous)});
    EXPECT_TRUE(WriteWholeFile(folder_ / "shows" / store::kChoiceFiles[generation % 2], {AsBytes(text)}));
  }
  std::string Played() {
    now_ += 1s;
    const auto chosen = LoadChosen(places_, now_);
    another_ = chosen && chosen->another;
    return chosen ? chosen->show.name : chosen.error().message();
  }

  const show::SecretKey company_ = show::MakeKey().value(), foreign_ = show::MakeKey().value();
  ShowPlaces places_{.root_pack = folder_ / "root/kaori.kaori",
                     .shows = folder_ / "shows",
                     .keys = folder_ / "settings/keys",
                     .play_log = folder_ / "plays",
                     .chosen = folder_ / "chosen"};
  Time now_ = Time{} + 1000s;
  bool another_ = false;
};

// A show that a stick brought has its own pictures for keys, and those of the show before go.
TEST_F(ChosenShowTest, LaysOutThePicturesOfKeysThatItBrings) {
  places_.key_files = folder_ / "keys";
  const show::KeyPicture blank{72, 0, false, {1}}, lit{72, 0xABC, true, {2, 3}}, strange{50, 7, false, {4}},
      bitmap{80, 0xABC, false, {5}};
  show::Show show = tests::SmallShow();
  show.name = "of the stick";
  ASSERT_TRUE(show::SavePackWithKeys({show, {blank, lit, strange, bitmap}},
                                     folder_ / "shows" / store::PackName(std::string(64, 'a')), &company_));
  Choose(1, 'a', 'a');
  EXPECT_EQ(Played(), "of the stick");
  EXPECT_EQ(ReadFile(folder_ / "keys/72/blank.jpg").value(), "\x01");
  EXPECT_EQ(ReadFile(folder_ / "keys/72/0000000000000abc-lit.jpg").value(), "\x02\x03");
  EXPECT_EQ(ReadFile(folder_ / "keys/80/0000000000000abc.bmp").value(), "\x05");
  EXPECT_FALSE(fs::exists(folder_ / "keys/50")) << "no deck has such keys";
  PutShow('b', "without", &company_);
  Choose(2, 'b', 'a');
  EXPECT_EQ(Played(), "without");
  EXPECT_TRUE(fs::is_empty(folder_ / "keys/72"));
}

TEST_F(ChosenShowTest, IsTheRootsWhereNoneWasChosen) {
  EXPECT_EQ(Played(), "of the root");
}

TEST_F(ChosenShowTest, ThatIsLostIsSaidToBeWhereTheFolderHoldsShows) {
  const auto said = [this] {
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(Played(), "of the root");
    return ::testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(said(), "") << "a new box";
  PutShow('a', "evening", &company_);
  EXPECT_THAT(said(), ::testing::HasSubstr("which one is to be played is lost"));
}

TEST_F(ChosenShowTest, IsNotSaidToBeLostWhereAFirstInstallationWasCutOff) {
  const std::string text = store::Format(store::Choice());
  EXPECT_TRUE(WriteWholeFile(folder_ / "shows" / store::kChoiceFiles[0], {AsBytes(text)}));
  PutShow('a', "evening", &company_);
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Played(), "of the root");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(ChosenShowTest, IsTheChosenOneAndAnotherThanBeforeOnce) {
  EXPECT_EQ(Played(), "of the root");
  NoteOrderlyEnd(places_);
  PutShow('a', "evening", &company_);
  Choose(1, 'a', 'b');
  EXPECT_EQ(Played(), "evening");
  EXPECT_TRUE(another_);
  EXPECT_EQ(Played(), "evening");
  EXPECT_FALSE(another_);
}

TEST_F(ChosenShowTest, ThatIsDamagedMissingOrNotTrustedIsPassedOver) {
  PutShow('b', "matinee", &company_);
  Choose(1, 'a', 'b');
  EXPECT_EQ(Played(), "matinee") << "there is no file";
  PutShow('a', "evening", &foreign_);
  EXPECT_EQ(Played(), "matinee") << "signed by somebody else";
  PutShow('a', "evening", &company_);
  EXPECT_EQ(Played(), "evening");
  NoteOrderlyEnd(places_);
  fs::resize_file(folder_ / "shows" / store::PackName(std::string(64, 'a')), 5000);
  EXPECT_EQ(Played(), "matinee") << "cut off";
}

TEST_F(ChosenShowTest, GivesWayWhereItEndsTheStageThreeTimes) {
  PutShow('a', "evening", &company_);
  PutShow('b', "matinee", &company_);
  Choose(1, 'a', 'b');
  for (int i = 0; i < 3; ++i) EXPECT_EQ(Played(), "evening");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(Played(), "matinee");
  for (int i = 0; i < 4; ++i) EXPECT_EQ(Played(), "of the root");
}

TEST_F(ChosenShowTest, GivesWayWhereItIsNeverSeenForLong) {
  PutShow('a', "evening", &company_);
  Choose(1, 'a', 'b');
  for (int i = 0; i < 3; ++i, now_ += 125s) EXPECT_EQ(Played(), "evening");
  EXPECT_EQ(Played(), "of the root");
}

TEST_F(ChosenShowTest, ThatHasBeenSeenForAMinuteIsNotToBlameForALaterEnd) {
  PutShow('a', "evening", &company_);
  Choose(1, 'a', 'b');
  for (int i = 0; i < 6; ++i, now_ += 125s) {
    EXPECT_EQ(Played(), "evening");
    ShowWatch watch(places_, 1, now_);
    EXPECT_FALSE(watch.IsOver(now_ + 59s));
    EXPECT_FALSE(watch.IsOver(now_ + 60s));
  }
}

// A file as a verified disk gives it of which a block is spoilt: mapped it would end the stage by a signal.
class SpoiltRootTest : public ChosenShowTest {
 protected:
  SpoiltRootTest() {
    places_.read_through = [this](const fs::path& file) -> Result<void> {
      ++readings_;
      if (file == places_.root_pack && is_spoilt_) return Fail(std::errc::io_error, "read " + file.string());
      return {};
    };
  }
  std::string Beside(const char* name) const { return ReadFile(folder_ / name).value_or(""); }

  bool is_spoilt_ = true;
  int readings_ = 0;
};

TEST_F(SpoiltRootTest, GivesWayToItsCopyAfterTwoEndsAndSaysSo) {
  Put(folder_ / "shows" / store::kCopyName, "the copy", nullptr);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(Played(), "of the root");
  EXPECT_EQ(readings_, 0) << "no start waits for it without a reason";
  EXPECT_EQ(Beside(store::kSpoiltFile), "");
  EXPECT_EQ(Played(), "the copy");
  EXPECT_THAT(Beside(store::kSpoiltFile), ::testing::HasSubstr("its copy plays"));
  EXPECT_THAT(Beside(store::kSpoiltFile), ::testing::HasSubstr("控えで上演中"));
  EXPECT_EQ(Played(), "the copy") << "the stage was ended once more";
  EXPECT_EQ(Beside(store::kNoShowFile), "");
}

TEST_F(SpoiltRootTest, WithoutACopyAsksForTheOtherSystem) {
  for (int i = 0; i < 2; ++i) EXPECT_EQ(Played(), "of the root");
  EXPECT_THAT(Played(), ::testing::HasSubstr("kaori.kaori"));
  EXPECT_THAT(Beside(store::kNoShowFile), ::testing::HasSubstr("kaori.kaori"));
  is_spoilt_ = false;
  EXPECT_EQ(Played(), "of the root");
  EXPECT_EQ(Beside(store::kNoShowFile), "");
}

TEST_F(SpoiltRootTest, WithASpoiltCopyAsksForTheOtherSystem) {
  Put(folder_ / "shows" / store::kCopyName, "the copy", nullptr);
  fs::resize_file(folder_ / "shows" / store::kCopyName, 5000);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(Played(), "of the root");
  EXPECT_THAT(Played(), ::testing::HasSubstr("root.copy"));
  EXPECT_THAT(Beside(store::kNoShowFile), ::testing::HasSubstr("root.copy"));
}

TEST_F(SpoiltRootTest, ThatReadsWellPlaysOn) {
  is_spoilt_ = false;
  Put(folder_ / "shows" / store::kCopyName, "the copy", nullptr);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(Played(), "of the root");
  EXPECT_EQ(readings_, 4);
}

// A show of a stick is checked as a whole at each start.
TEST_F(SpoiltRootTest, IsNoReasonToLeaveAChosenShow) {
  PutShow('a', "evening", &company_);
  Choose(1, 'a', 'a');
  for (int i = 0; i < 3; ++i) EXPECT_EQ(Played(), "evening");
  EXPECT_EQ(Played(), "of the root");
}

TEST_F(SpoiltRootTest, IsCopiedOnceItWasSeenForAMinute) {
  EXPECT_EQ(Played(), "of the root");
  ShowWatch watch(places_, 0, now_);
  EXPECT_FALSE(watch.IsOver(now_ + 59s));
  EXPECT_FALSE(fs::exists(folder_ / store::kSettledFile));
  EXPECT_FALSE(watch.IsOver(now_ + 60s));
  EXPECT_TRUE(fs::exists(folder_ / store::kSettledFile));
}

TEST_F(ChosenShowTest, IsOverOnceAnotherOneIsChosen) {
  ShowWatch watch(places_, 2, now_);
  EXPECT_FALSE(watch.IsOver(now_)) << "nothing was said";
  std::ofstream(places_.chosen) << "2\n";
  EXPECT_FALSE(watch.IsOver(now_));
  std::ofstream(places_.chosen) << "3\n";
  EXPECT_TRUE(watch.IsOver(now_));
}

// Else the stage would end at each start, for ever.
TEST_F(ChosenShowTest, IsNotWaitedForWhereTheDiskHasLostTheChoice) {
  std::ofstream(places_.chosen) << "7\n";
  const auto chosen = LoadChosen(places_, now_);
  ASSERT_TRUE(chosen);
  EXPECT_FALSE(ShowWatch(places_, chosen->generation, now_).IsOver(now_));
}

TEST(Rehearsal, PassesAShowAndRefusesOneInWhichNothingIsSeen) {
  EXPECT_TRUE(Rehearse(tests::SmallShow()));
  show::Show dark = tests::SmallShow();
  for (auto& each : dark.scenes) each.exposure = 0;
  const auto refused = Rehearse(std::move(dark));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(), "nothing is seen in any of the show's scenes");
}

}  // namespace
}  // namespace kaori::stage
