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
