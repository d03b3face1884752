// What is said and done while the service key is on and a stick is in: shows, keys, ways back, and what is wrong.
#include <sys/stat.h>

#include "tests/appliance/programs/shows_service_fixture.h"

namespace kaori::shows {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST_F(ServiceTest, TwoShowsOnAStickAreListedAndTheOneThatIsTakenPlaysNext) {
  PutOnStick("evening", &company_);
  PutOnStick("matinee", &company_);
  plugged_ = true;
  const std::string listed = Play(1s);
  EXPECT_THAT(listed, HasSubstr("> 1. evening"));
  EXPECT_THAT(listed, HasSubstr("  2. matinee"));
  Strike(board::key::k1 + 1);
  EXPECT_THAT(Play(2s), HasSubstr("matinee: it is on the box; the face changes to it"));
  EXPECT_EQ(ReadFile(folder_ / "report" / "chosen").value_or(""), "1\n");
  const auto current = store::ReadChoice(folder_ / "shows").current;
  EXPECT_EQ(NameIn(folder_ / "shows" / store::PackName(current)), "matinee");
}

TEST_F(ServiceTest, ATheatresKeyIsTakenFromTheStickAndThenItsShow) {
  PutOnStick("guest", &theatre_);
  ASSERT_TRUE(SaveKey(theatre_, folder_ / "stick" / "theatre"));
  plugged_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("2. key theatre  " + show::Fingerprint(theatre_.public_key())));
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr("guest: this box does not trust its signer"));
  Strike(board::key::k1 + 1);
  const std::string asked = Play(1s);
  EXPECT_THAT(asked, HasSubstr("theatre: " + std::string(Words(Message::kAskKey, Language::kEnglish))));
  EXPECT_THAT(asked, HasSubstr("> 1. leave this key out"));
  EXPECT_THAT(asked, HasSubstr("key theatre  " + show::Fingerprint(theatre_.public_key())));
  EXPECT_FALSE(fs::exists(folder_ / "settings/keys")) << "nobody has agreed";
  Strike(board::key::k1 + 1);
  EXPECT_THAT(Play(1s), HasSubstr("theatre: this key is on the box now"));
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr("guest: it is on the box; the face changes to it"));
}

TEST_F(ServiceTest, AKeyThatIsLeftOutAndOneWhoseStickIsPulledAreNotTaken) {
  PutOnStick("guest", &theatre_);
  ASSERT_TRUE(SaveKey(theatre_, folder_ / "stick" / "theatre"));
  plugged_ = true;
  Play(1s);
  Strike(board::key::k1 + 1);
  Play(1s);
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr("the box stays as it is"));
  Strike(board::key::k1 + 1);
  EXPECT_THAT(Play(1s), HasSubstr("yes, trust this key")) << "the stick's list had its numbers again";
  plugged_ = false;
  EXPECT_THAT(Play(1s), ::testing::Not(HasSubstr("yes, trust this key")));
  Strike(board::key::k1 + 1);
  Play(1s);
  EXPECT_FALSE(fs::exists(folder_ / "settings/keys"));
}

TEST_F(ServiceTest, WhoeverPressesAgainWhileItIsCopiedTakesNothingMore) {
  PutOnStick("evening", &company_);
  PutOnStick("matinee", &company_);
  plugged_ = true;
  Play(1s);
  Strike(board::key::k1);
  service_.Step(now_);
  Strike(board::key::k1 + 1);
  EXPECT_THAT(Play(2s), HasSubstr("evening: it is on the box; the face changes to it"));
  EXPECT_EQ(store::ReadChoice(folder_ / "shows").generation, 1U);
}

TEST_F(ServiceTest, AShowIsCopiedNoFurtherWhileTheFaceNeedsTheBox) {
  PutOnStick("evening", &company_);
  plugged_ = true;
  Play(1s);
  may_work_ = false;
  Strike(board::key::k1);
  EXPECT_THAT(Play(1min), HasSubstr("evening: it is being copied"));
  may_work_ = true;
  EXPECT_THAT(Play(2s), HasSubstr("evening: it is on the box; the face changes to it"));
}

TEST_F(ServiceTest, HalfACopyGoesWithTheProgram) {
  std::ofstream(folder_ / "shows" / "incoming") << "of the day before";
  InstallService again{{folder_ / "root-keys", folder_ / "settings/keys", folder_ / "report"},
                       *shows_,
                       board_,
                       []() -> Result<std::optional<fs::path>> { return std::optional<fs::path>(); },
                       [](const fs::path&) -> Result<void> { return {}; }};
  EXPECT_FALSE(fs::exists(folder_ / "shows" / "incoming"));
}

TEST_F(ServiceTest, WhatIsWrongIsSaidInBothLanguagesAndNothingIsChosen) {
  PutOnStick("evening", &company_);
  trial_ = FailInput("nothing is seen in any of the show's scenes");
  plugged_ = true;
  Play(1s);
  Strike(board::key::kEnter);
  const std::string said = Play(1s);
  EXPECT_THAT(said, HasSubstr("evening: it does not play on this box"));
  EXPECT_THAT(said, HasSubstr("(nothing is seen"));
  EXPECT_THAT(said, HasSubstr(Words(Message::kUnplayable, Language::kJapanese)));
  EXPECT_EQ(store::ReadChoice(folder_ / "shows"), store::Choice());
}

TEST_F(ServiceTest, AnEmptyStickIsSaidToBeEmptyAndOddFilesAreNotFollowed) {
  fs::create_symlink("/etc/passwd", folder_ / "stick" / "link.kaori");
  fs::create_directories(folder_ / "stick" / "folder.kaori");
  ASSERT_EQ(::mkfifo((folder_ / "stick" / "pipe.kaori").c_str(), 0600), 0);
  plugged_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("there is no show on the stick"));
}

TEST_F(ServiceTest, AStickOfAnotherFileSystemIsSaidToBeOneAndAGoodOneIsListedAfterIt) {
  PutOnStick("evening", &company_);
  unreadable_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("it has to be FAT32 or exFAT (mount the stick"));
  unreadable_ = false;
  plugged_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("> 1. evening"));
  plugged_ = false;
  EXPECT_THAT(Play(1s), HasSubstr("plug a stick in"));
  Strike(board::key::k1);
  Play(1s);
  EXPECT_EQ(store::ReadChoice(folder_ / "shows"), store::Choice())
      << "nothing is taken from a stick that is out";
}

TEST_F(ServiceTest, AKeyIsTakenAsItWasShownThoughTheStickSaysAnotherLater) {
  ASSERT_TRUE(SaveKey(theatre_, folder_ / "stick" / "theatre"));
  plugged_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("1. key theatre  " + show::Fingerprint(theatre_.public_key())));
  const auto other = show::MakeKey().value();
  fs::remove(folder_ / "stick" / "theatre.pub");
  fs::remove(folder_ / "stick" / "theatre");
  ASSERT_TRUE(SaveKey(other, folder_ / "stick" / "theatre"));
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr(show::Fingerprint(theatre_.public_key())));
  Strike(board::key::k1 + 1);
  EXPECT_THAT(Play(1s), HasSubstr(show::Fingerprint(theatre_.public_key())));
  const auto kept = show::ReadPublicKeys({folder_ / "settings/keys"});
  ASSERT_TRUE(kept);
  EXPECT_THAT(*kept, ElementsAre(theatre_.public_key()));
}

TEST_F(ServiceTest, AShowIsSaidToPlayWhenTheStageHasPresentedAFrameOfIt) {
  PutOnStick("evening", &company_);
  plugged_ = true;
  Play(1s);
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr("evening: it is on the box; the face changes to it in a moment"));
  const store::Choice choice = store::ReadChoice(folder_ / "shows");
  NoteThatPlays(0, std::string(store::kRootShow));
  Present(7);
  EXPECT_THAT(Play(1s), HasSubstr("in a moment")) << "another show plays still";
  NoteThatPlays(choice.generation, choice.current);
  EXPECT_THAT(Play(1s), HasSubstr("in a moment")) << "the show is read";
  Present(8);
  EXPECT_THAT(Play(1s), HasSubstr("evening: it is on the box and plays now"));
}

TEST_F(ServiceTest, AShowThatTheStageGaveUpIsSaidToBeUnplayable) {
  PutOnStick("evening", &company_);
  plugged_ = true;
  Play(1s);
  Strike(board::key::k1);
  Play(1s);
  const store::Choice choice = store::ReadChoice(folder_ / "shows");
  NoteThatPlays(choice.generation, choice.current);
  Play(1s);
  NoteThatPlays(choice.generation, std::string(store::kRootShow));
  EXPECT_THAT(Play(1s), HasSubstr("! evening: it does not play on this box"));
}

TEST_F(ServiceTest, OneGoesBackToTheShowBeforeAndToTheBoxsOwn) {
  PutOnStick("evening", &company_);
  PutOnStick("matinee", &company_);
  plugged_ = true;
  EXPECT_THAT(Play(1s), ::testing::Not(HasSubstr("back to"))) << "the box's own show plays";
  Strike(board::key::k1);
  Play(2s);
  const std::string evening = store::ReadChoice(folder_ / "shows").current;
  Strike(board::key::k1 + 1);
  const std::string said = Play(2s);
  EXPECT_THAT(said, HasSubstr("  3. back to the show before\n"));
  EXPECT_THAT(said, HasSubstr("  4. back to the box's own show\n"));
  Strike(board::key::k1 + 2);
  EXPECT_THAT(Play(1s), HasSubstr("back to the show before: it is on the box"));
  EXPECT_EQ(store::ReadChoice(folder_ / "shows").current, evening);
  EXPECT_EQ(ReadFile(folder_ / "report" / "chosen").value_or(""), "3\n");
  Strike(board::key::k1 + 3);
  Play(1s);
  const store::Choice last = store::ReadChoice(folder_ / "shows");
  EXPECT_EQ(last.current, store::kRootShow);
  EXPECT_EQ(last.previous, evening);
}

TEST_F(ServiceTest, ARefusalBearsAMarkAndWhatWentWellDoesNot) {
  PutOnStick("guest", &theatre_);
  plugged_ = true;
  EXPECT_THAT(Play(1s), ::testing::Not(HasSubstr("! ")));
  Strike(board::key::k1);
  const std::string said = Play(1s);
  EXPECT_THAT(said, ::testing::StartsWith("! guest: this box does not trust its signer"));
  EXPECT_THAT(said, HasSubstr("\n! guest: " + std::string(Words(Message::kForeign, Language::kJapanese))));
}

TEST_F(ServiceTest, ThatAStickCannotBeReadIsForgottenWhenItIsOut) {
  unreadable_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("it has to be FAT32 or exFAT"));
  unreadable_ = false;
  EXPECT_THAT(Play(1s), HasSubstr("plug a stick in"));
}

TEST_F(ServiceTest, ManyShowsLeaveRoomForTheKeyAndTheRestIsCounted) {
  for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h", "i"}) PutOnStick(name, &theatre_);
  ASSERT_TRUE(SaveKey(theatre_, folder_ / "stick" / "theatre"));
  plugged_ = true;
  const std::string said = Play(1s);
  EXPECT_THAT(said, HasSubstr("  8. h  "));
  EXPECT_THAT(said, HasSubstr("  9. key theatre  "));
  EXPECT_THAT(said, HasSubstr("  10. support file for a technician"));
  EXPECT_THAT(said, HasSubstr("  and 1 more on the stick"));
  Strike(board::key::k0);
  EXPECT_THAT(Play(1s), HasSubstr("it is on the stick, for a technician")) << "the key 0 is the tenth line's";
}

TEST_F(ServiceTest, NamesInCapitalsAreSeen) {
  PutOnStick("evening", &company_);
  fs::rename(folder_ / "stick" / "evening.kaori", folder_ / "stick" / "EVENING.KAORI");
  ASSERT_TRUE(SaveKey(theatre_, folder_ / "stick" / "theatre"));
  fs::rename(folder_ / "stick" / "theatre.pub", folder_ / "stick" / "THEATRE.PUB");
  plugged_ = true;
  const std::string said = Play(1s);
  EXPECT_THAT(said, HasSubstr("> 1. EVENING"));
  EXPECT_THAT(said, HasSubstr("  2. key THEATRE"));
}

// Both a file's name and what a trial says come from the stick.
TEST_F(ServiceTest, ALineEndFromTheStickForgesNoLine) {
  PutOnStick("one\nforged", &company_);
  trial_ = FailInput("scene\nforged: it is on the box and plays now \x1b[2J");
  plugged_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("one?forged"));
  Strike(board::key::kEnter);
  EXPECT_THAT(Play(1s), ::testing::Not(HasSubstr("\nforged")));
}

}  // namespace
}  // namespace kaori::shows
