// Backup and restore at the box: the list, the question, the answers, and what is refused.
#include "appliance/core/restore/apply.h"
#include "appliance/core/restore/plan.h"
#include "appliance/programs/shows/box_copies.h"
#include "appliance/programs/shows/restore_disk.h"
#include "tests/appliance/programs/shows_service_fixture.h"

namespace kaori::shows {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class CopiesTest : public ServiceTest {
 protected:
  CopiesTest() : ServiceTest(Offers::kCopies) {
    for (const char* each : {"settings/keys", "own/log", "lips"}) fs::create_directories(folder_ / each);
    Put("settings/box.toml", "name = \"left\"\nprofile = \"stage\"\n");
    Put("own/01-smile.toml", "smile");
    Put("own/log/evening", "a report");
    Put("lips/lips.settings", "lips");
    plugged_ = true;
  }
  std::string BackUp() { return Choose("backup of this box"); }
  // What the start of the box does.
  void Start() { ASSERT_TRUE(restore::FinishRestore(folder_).value()); }
  static constexpr const char* kFile = "stick/left-1a2b3c4d-20261119-070640.kaorishow";
};

TEST_F(CopiesTest, ABackupIsWrittenOntoTheStickWhichIsWritableForAsLong) {
  const std::string said = BackUp();
  EXPECT_THAT(said, HasSubstr("the backup is on the stick"));
  EXPECT_THAT(said, HasSubstr(Words(Message::kBackedUp, Language::kJapanese)));
  EXPECT_FALSE(writable_);
  EXPECT_EQ(opened_, 1);
  EXPECT_THAT(said, HasSubstr("restore left-1a2b3c4d")) << "it is offered at once";
}

TEST_F(CopiesTest, ARestoreSaysWhatDiffersAndChangesNothingBeforeYes) {
  BackUp();
  Put("own/01-smile.toml", "grin");
  Put("own/02-frown.toml", "frown");
  fs::remove(folder_ / "lips/lips.settings");
  const std::string said = Choose("restore left");
  EXPECT_THAT(said, HasSubstr(Words(Message::kAskChange, Language::kEnglish)));
  EXPECT_THAT(said, HasSubstr("> 1. leave the box as it is"));
  EXPECT_THAT(said, HasSubstr("changed own/01-smile.toml"));
  EXPECT_THAT(said, HasSubstr("gone    own/02-frown.toml"));
  EXPECT_THAT(said, HasSubstr("new     lips/lips.settings"));
  EXPECT_THAT(said, Not(HasSubstr("settings/box.toml")));
  EXPECT_FALSE(fs::exists(folder_ / restore::kNext));
  EXPECT_THAT(Choose("leave the box"), HasSubstr("the box stays as it is"));
  EXPECT_EQ(Text("own/01-smile.toml"), "grin");
  EXPECT_FALSE(fs::exists(folder_ / restore::kIncoming));
}

TEST_F(CopiesTest, ABackupRestsForAsLongAsTheFaceNeedsItAndARestoreDoesNot) {
  may_work_ = false;
  EXPECT_THAT(BackUp(), HasSubstr(Words(Message::kBackingUp, Language::kEnglish)));
  EXPECT_THAT(Play(60s), Not(HasSubstr("the backup is on the stick")));
  may_work_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("the backup is on the stick"));
  Put("own/01-smile.toml", "grin");
  may_work_ = false;
  Choose("restore left");
  EXPECT_THAT(Play(1s), HasSubstr("yes, restore this"));
}

TEST_F(CopiesTest, ARestoreIsDoneAtTheNextStartAndCanBeUndone) {
  BackUp();
  Put("own/01-smile.toml", "grin");
  Choose("restore left");
  EXPECT_THAT(Choose("yes, restore this"), HasSubstr("switch the box off and on"));
  EXPECT_EQ(Text("own/01-smile.toml"), "grin") << "what plays is not disturbed";
  Start();
  EXPECT_EQ(Text("own/01-smile.toml"), "smile");
  plugged_ = false;
  Play(1s);
  Strike(board::key::kPageUp);
  EXPECT_THAT(Choose("back to what was here before the restore"),
              HasSubstr("what was there before comes back"));
  Start();
  EXPECT_EQ(Text("own/01-smile.toml"), "grin");
}

TEST_F(CopiesTest, ABoxWithNothingGetsTheShowAndEverythingButTheNameAndTheReports) {
  PutOnStick("evening", &company_);
  Choose("1. evening");
  const auto id = store::ReadChoice(folder_ / "shows").current;
  Put("settings/keys/company.pub", show::PublicKeyLine(company_.public_key()));
  BackUp();
  for (const char* each : {"own", "lips", "settings", "shows", "root-keys"}) fs::remove_all(folder_ / each);
  fs::create_directories(folder_ / "shows");
  fs::create_directories(folder_ / "settings");
  Put("settings/box.toml", "name = \"right\"\n");
  fs::remove(folder_ / "stick/evening.kaori");
  const std::string said = Choose("restore left");
  EXPECT_THAT(said, HasSubstr("show " + id.substr(0, 8) + " in place of the box's own one"));
  EXPECT_THAT(said,
              HasSubstr("new     settings/keys/company.pub  " + show::Fingerprint(company_.public_key())));
  Choose("yes, restore this");
  Start();
  EXPECT_EQ(store::ReadChoice(folder_ / "shows").current, id);
  EXPECT_TRUE(fs::exists(folder_ / "shows" / store::PackName(id)));
  EXPECT_EQ(Text("lips/lips.settings"), "lips");
  EXPECT_EQ(Text("settings/box.toml"), "name = \"right\"\nprofile = \"stage\"\n");
  EXPECT_EQ(Text("own/log/evening"), "nothing") << "a report says what one box did";
}

// Whoever agrees has seen whom the box would trust and what it would authorise, however much comes besides.
TEST_F(CopiesTest, ARestoreHidesNoKeyAndNoSettingBehindManyFiles) {
  const auto name = [](int n) { return "own/0" + std::to_string(n) + "-smile.toml"; };
  for (int n = 1; n < 10; ++n) Put(name(n), "smile");
  Put("settings/keys/company.pub", show::PublicKeyLine(company_.public_key()));
  Put("settings/box.toml", "name = \"left\"\nprofile = \"bench\"\n");
  BackUp();
  for (int n = 1; n < 10; ++n) fs::remove(folder_ / name(n));
  fs::remove(folder_ / "settings/keys/company.pub");
  Put("settings/box.toml", "name = \"left\"\nprofile = \"stage\"\n");
  const std::string said = Choose("restore left");
  EXPECT_THAT(said,
              HasSubstr("new     settings/keys/company.pub  " + show::Fingerprint(company_.public_key())));
  EXPECT_THAT(said, HasSubstr("changed profile  \"stage\" -> \"bench\""));
  EXPECT_THAT(said, HasSubstr("and 3 more\n"));
  EXPECT_THAT(said, Not(HasSubstr("settings/box.toml"))) << "its settings are named one by one";
}

TEST_F(CopiesTest, ARestoreOfMoreKeysThanAScreenHoldsSaysHowManyThereAre) {
  const auto name = [](int n) { return "settings/keys/" + std::to_string(n) + ".pub"; };
  for (int n = 0; n < 12; ++n) Put(name(n), show::PublicKeyLine(show::MakeKey().value().public_key()));
  BackUp();
  for (int n = 0; n < 12; ++n) fs::remove(folder_ / name(n));
  EXPECT_THAT(Choose("restore left"), HasSubstr("and 4 more, 4 of them keys"));
}

// The second restore is confirmed before the first was done: the first one's files are none of its own.
TEST_F(CopiesTest, ALaterRestoreTakesThePlaceOfOneThatWaits) {
  BackUp();
  Put("own/01-smile.toml", "grin");
  Put("lips/lips.settings", "other lips");
  Choose("restore left");
  Choose("yes, restore this");
  Put("lips/lips.settings", "lips");
  Choose("restore left");
  EXPECT_THAT(Choose("yes, restore this"), HasSubstr("switch the box off and on"));
  const auto plan = restore::ParsePlan(Text(std::string(restore::kNext) + "/" + restore::kPlan));
  ASSERT_TRUE(plan);
  EXPECT_THAT(plan->put, ::testing::ElementsAre("own/01-smile.toml"));
  EXPECT_FALSE(fs::exists(folder_ / restore::kDropped));
  Start();
  EXPECT_EQ(Text("own/01-smile.toml"), "smile");
}

TEST_F(CopiesTest, AShowOfNobodyWhomTheBoxKnowsIsRefused) {
  PutOnStick("evening", &company_);
  Choose("1. evening");
  BackUp();
  fs::remove_all(folder_ / "root-keys");
  EXPECT_THAT(Choose("restore left"), HasSubstr("does not trust its signer"));
  EXPECT_FALSE(fs::exists(folder_ / restore::kIncoming));
}

TEST_F(CopiesTest, AShowThatDoesNotPlayHereIsRefused) {
  PutOnStick("evening", &company_);
  Choose("1. evening");
  BackUp();
  for (const auto& pack : fs::directory_iterator(folder_ / "shows")) fs::remove(pack);
  trial_ = FailInput("it needs more memory");
  EXPECT_THAT(Choose("restore left"), HasSubstr("it does not play on this box"));
}

TEST_F(CopiesTest, ADamagedBackupIsRefusedInWordsAndChangesNothing) {
  BackUp();
  std::string text = Text(kFile);
  text.at(text.rfind("smile")) = 'X';
  Put(kFile, text);
  Put("own/01-smile.toml", "grin");
  const std::string said = Choose("restore left");
  EXPECT_THAT(said, HasSubstr("! left-1a2b3c4d-20261119-070640: it is damaged"));
  EXPECT_EQ(Text("own/01-smile.toml"), "grin");
  EXPECT_FALSE(fs::exists(folder_ / restore::kIncoming));
}

// The show log comes last in a backup, and nothing of it is written: its end cannot be a fault of the disk.
TEST_F(CopiesTest, ABackupThatEndsWithinItsReportsIsSaidToBeCutOff) {
  BackUp();
  const std::string text = Text(kFile);
  Put(kFile, text.substr(0, text.rfind("a report") + 3));
  EXPECT_THAT(Choose("restore left"), HasSubstr("its end is missing"));
}

TEST_F(CopiesTest, AStickThatIsPulledEndsTheQuestion) {
  BackUp();
  Put("own/01-smile.toml", "grin");
  Choose("restore left");
  plugged_ = false;
  EXPECT_THAT(Play(1s), Not(HasSubstr("yes, restore this")));
  EXPECT_FALSE(fs::exists(folder_ / restore::kIncoming));
}

TEST_F(CopiesTest, ABoxThatHasAllOfItIsToldSo) {
  BackUp();
  EXPECT_THAT(Choose("restore left"), HasSubstr("the box has all of it already"));
}

TEST_F(CopiesTest, AStickThatCannotBeWrittenIsSaidInWords) {
  closed_ = Fail(std::errc::read_only_file_system, "write on the stick");
  EXPECT_THAT(BackUp(), HasSubstr("the stick cannot be written"));
}

TEST_F(CopiesTest, AKeyThatIsTurnedBackLeavesNothing) {
  {
    std::ofstream(folder_ / "stick/cut.kaorishow") << "x";
    BoxCopies copies({.data = folder_,
                      .name = [] { return std::string("left"); },
                      .wall = [] { return std::time_t{}; },
                      .set_writable = [](bool) { return Result<void>{}; }},
                     {});
    copies.Begin({.kind = Choosable::Kind::kBackup, .offer = {}, .remark = {}}, folder_ / "stick", {});
    copies.Step();
    ASSERT_TRUE(copies.busy());
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "stick"), {}), 1);
}

}  // namespace
}  // namespace kaori::shows
