// From the stick to the show: what is listed, marked and taken, on a real disk and with a real trial.
#include <gmock/gmock.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "appliance/core/board/keys.h"
#include "appliance/core/board/press_log.h"
#include "appliance/programs/shows/install_service.h"
#include "appliance/programs/shows/stick_mount.h"
#include "appliance/programs/shows/trial.h"
#include "drivers/base/read_file.h"
#include "tests/appliance/core/board_file.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::shows {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MenuTest : public ::testing::Test {
 protected:
  std::string Taken() {
    const auto taken = menu_.Read(keys_, surface_, lines_);
    return taken ? taken->offer.name : "";
  }
  void Strike(std::uint8_t usage) { board::NotePress(keys_.value, usage, now_); }
  void Show(std::initializer_list<const char*> names) {
    std::vector<Choosable> choices;
    for (const char* name : names)
      choices.push_back({Choosable::Kind::kShow, {.file = name, .name = name}, "1 MB"});
    menu_.Offer(choices);
    EXPECT_EQ(Taken(), "");
  }

  Menu menu_;
  board::Stamped<board::Keys> keys_;
  board::Stamped<board::Surface> surface_;
  board::Stamped<board::Lines> lines_;
  Time now_{};
};

TEST_F(MenuTest, GoTakesTheMarkedShowAndANumberAnyOfThem) {
  Show({"evening", "matinee"});
  ++lines_.value.pushes[0];
  EXPECT_EQ(Taken(), "evening");
  EXPECT_EQ(Taken(), "") << "one push takes once";
  Strike(board::key::k1 + 1);
  EXPECT_EQ(Taken(), "matinee");
  board::NotePress(surface_.value, 0, now_);
  EXPECT_EQ(Taken(), "evening");
  Strike(board::key::k1 + 2);
  EXPECT_EQ(Taken(), "") << "there is no third one";
}

TEST_F(MenuTest, ArrowsMoveTheMark) {
  Show({"evening", "matinee"});
  Strike(board::key::kDown);
  Strike(board::key::kDown);
  EXPECT_EQ(Taken(), "");
  EXPECT_THAT(menu_.Lines(Message::kChoose, Language::kEnglish),
              ElementsAre(HasSubstr("GO"), "  1  evening  1 MB", "> 2  matinee  1 MB"));
  Strike(board::key::kEnter);
  EXPECT_EQ(Taken(), "matinee");
}

TEST_F(MenuTest, APressFromBeforeTheStickCameTakesNothing) {
  Strike(board::key::kEnter);
  ++lines_.value.pushes[0];
  Show({"evening"});
  EXPECT_EQ(Taken(), "");
}

TEST(Sticks, AreFoundOnUsbAloneAndByTheirPartitions) {
  std::string name = (fs::temp_directory_path() / "kaori-blocks-XXXXXX").string();
  const fs::path sys = ::mkdtemp(name.data());
  const auto device = [&](const std::string& path, bool partition) {
    fs::create_directories(sys / path);
    if (partition) std::ofstream(sys / path / "partition") << "1\n";
    fs::create_directories(sys / "class");
    fs::create_directory_symlink(sys / path, sys / "class" / fs::path(path).filename());
  };
  device("pci/ata1/sda", false);
  device("pci/ata1/sda/sda1", true);
  device("pci/usb1/1-2/sdb", false);
  device("pci/usb1/1-2/sdb/sdb1", true);
  device("pci/usb1/1-3/sdc", false);
  EXPECT_THAT(FindSticks(sys / "class"), ElementsAre("sdb1", "sdc"));
  fs::remove_all(sys);
}

// A service over a folder that stands for a mounted stick.
class ServiceTest : public tests::PackTest {
 protected:
  ServiceTest() {
    for (const char* each : {"stick", "shows", "report", "root-keys"}) fs::create_directories(folder_ / each);
    EXPECT_TRUE(SaveKey(company_, folder_ / "root-keys" / "company"));
  }
  void PutOnStick(const std::string& name, const show::SecretKey* signer) {
    show::Show show = tests::SmallShow();
    show.name = name;
    EXPECT_TRUE(show::SavePack(show, folder_ / "stick" / (name + ".kaori"), signer));
  }
  void Strike(std::uint8_t usage) {
    board::NotePress(pressed_, usage, now_);
    keys_.Write(pressed_, now_, board::SourceState::kLive);
  }
  // As the stage does when it begins a show.
  void NoteThatPlays(std::uint64_t generation, const std::string& show) {
    std::ofstream(folder_ / "plays") << store::Format(
        store::PlayLog{.generation = generation, .playing = show});
  }
  void Present(std::uint32_t frames) { stage_.Write({.frames = frames}, now_, board::SourceState::kLive); }
  std::string Play(Duration time) {
    for (const Time end = now_ + time; now_ < end; now_ += InstallService::kPeriod) service_.Step(now_);
    return ReadFile(folder_ / "report" / "lines").value_or("");
  }

  const show::SecretKey company_ = show::MakeKey().value(), theatre_ = show::MakeKey().value();
  bool plugged_ = false, unreadable_ = false;
  Result<void> trial_{};
  board::Board board_ = board::Board::Create((folder_ / "board").string()).value();
  board::Writer<board::Keys> keys_ = board_.AcquireWriter<board::Keys>().value();
  board::Writer<board::StageStatus> stage_ = board_.AcquireWriter<board::StageStatus>().value();
  board::Keys pressed_;
  Time now_ = Time{} + 1000s;
  std::unique_ptr<Folder> shows_ = OpenFolder(folder_ / "shows");
  InstallService service_{
      {folder_ / "root-keys", folder_ / "settings/keys", folder_ / "report", folder_ / "plays"},
      *shows_,
      board_,
      [this]() -> Result<std::optional<fs::path>> {
        if (unreadable_) return FailInput("mount the stick /dev/sdb1");
        if (!plugged_) return std::optional<fs::path>();
        return std::optional(folder_ / "stick");
      },
      [this](const fs::path&) { return trial_; }};
};

TEST_F(ServiceTest, TwoShowsOnAStickAreListedAndTheOneThatIsTakenPlaysNext) {
  PutOnStick("evening", &company_);
  PutOnStick("matinee", &company_);
  plugged_ = true;
  const std::string listed = Play(1s);
  EXPECT_THAT(listed, HasSubstr("> 1  evening"));
  EXPECT_THAT(listed, HasSubstr("  2  matinee"));
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
  EXPECT_THAT(Play(1s), HasSubstr("2  key theatre  " + show::Fingerprint(theatre_.public_key())));
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr("guest: this box does not trust its signer"));
  Strike(board::key::k1 + 1);
  EXPECT_THAT(Play(1s), HasSubstr("this key is on the box now"));
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr("guest: it is on the box; the face changes to it"));
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
  EXPECT_THAT(Play(1s), HasSubstr("> 1  evening"));
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
  EXPECT_THAT(Play(1s), HasSubstr("1  key theatre  " + show::Fingerprint(theatre_.public_key())));
  const auto other = show::MakeKey().value();
  fs::remove(folder_ / "stick" / "theatre.pub");
  fs::remove(folder_ / "stick" / "theatre");
  ASSERT_TRUE(SaveKey(other, folder_ / "stick" / "theatre"));
  Strike(board::key::k1);
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
  EXPECT_THAT(said, HasSubstr("  3  back to the show before\n"));
  EXPECT_THAT(said, HasSubstr("  4  back to the box's own show\n"));
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
  EXPECT_THAT(said, HasSubstr("  7  g  "));
  EXPECT_THAT(said, HasSubstr("  8  key theatre  "));
  EXPECT_THAT(said, HasSubstr("  and 2 more on the stick"));
}

TEST_F(ServiceTest, NamesInCapitalsAreSeen) {
  PutOnStick("evening", &company_);
  fs::rename(folder_ / "stick" / "evening.kaori", folder_ / "stick" / "EVENING.KAORI");
  ASSERT_TRUE(SaveKey(theatre_, folder_ / "stick" / "theatre"));
  fs::rename(folder_ / "stick" / "theatre.pub", folder_ / "stick" / "THEATRE.PUB");
  plugged_ = true;
  const std::string said = Play(1s);
  EXPECT_THAT(said, HasSubstr("> 1  EVENING"));
  EXPECT_THAT(said, HasSubstr("  2  key THEATRE"));
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

// A shell that closes its standard error, and stays.
TEST(Trial, OfAProgramThatSaysNoMoreAndDoesNotEndIsCutOff) {
  std::string name = (fs::temp_directory_path() / "kaori-silent-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  std::ofstream(folder / "stays") << "#!/bin/sh\nexec 2>&-\nexec sleep 3600\n";
  fs::permissions(folder / "stays", fs::perms::owner_all);
  const auto tried = TryPack(folder / "stays", "x", 1s);
  ASSERT_FALSE(tried);
  EXPECT_EQ(tried.error().cause, std::errc::timed_out);
  fs::remove_all(folder);
}

// A shell tells the rights that it has, in place of the stage. The process that gives its own up is another one.
TEST(Trial, HasNoneOfTheRightsOfWhoStartsIt) {
  if (::prctl(PR_CAPBSET_READ, CAP_SYS_ADMIN) != 1 || ::prctl(PR_CAPBSET_READ, CAP_SETPCAP) != 1 ||
      ::geteuid() != 0)
    GTEST_SKIP() << "this process has no right to mount that it could keep";
  std::string name = (fs::temp_directory_path() / "kaori-rights-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  std::ofstream(folder / "mounts") << "#!/bin/sh\n[ $((0x$(sed -n 's/^CapEff:\\s*//p' "
                                      "/proc/self/status) >> 21 & 1)) = 1 ]\n";
  fs::permissions(folder / "mounts", fs::perms::owner_all);
  EXPECT_TRUE(TryPack(folder / "mounts", "x")) << "the shell finds the right where it has it";
  const auto try_without = [&] {
    const bool kept = KeepRightsToOurselves().has_value();
    std::exit(kept && !TryPack(folder / "mounts", "x") ? 0 : 1);
  };
  EXPECT_EXIT(try_without(), ::testing::ExitedWithCode(0), "");
  fs::remove_all(folder);
}

// Another program stands for the stage.
TEST(Trial, SaysWhatTheOtherProcessSaidLastAndEndsOneThatHangs) {
  EXPECT_TRUE(TryPack("/bin/true", "x"));
  EXPECT_THAT(TryPack("/bin/ls", "/nowhere/x").error().message(), HasSubstr("--help"));
  EXPECT_EQ(TryPack("/nowhere/stage", "x").error().cause, std::errc::no_such_file_or_directory);
  std::string name = (fs::temp_directory_path() / "kaori-trial-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  std::ofstream(folder / "hangs") << "#!/bin/sh\nexec sleep 60\n";
  std::ofstream(folder / "dies") << "#!/bin/sh\nkill -SEGV $$\n";
  for (const char* each : {"hangs", "dies"}) fs::permissions(folder / each, fs::perms::owner_all);
  EXPECT_EQ(TryPack(folder / "hangs", "x", 100ms).error().cause, std::errc::timed_out);
  int asked = 0;
  EXPECT_EQ(TryPack(folder / "hangs", "x", 60s, [&] { return ++asked < 2; }).error().cause,
            std::errc::operation_canceled);
  EXPECT_THAT(TryPack(folder / "dies", "x").error().message(), HasSubstr("signal 11"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace kaori::shows
