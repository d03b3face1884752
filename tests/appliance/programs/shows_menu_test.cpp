// What is listed, marked and taken, and where sticks are found.
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "appliance/core/board/keys.h"
#include "appliance/core/board/press_log.h"
#include "appliance/programs/shows/menu.h"
#include "appliance/programs/shows/stick_mount.h"

namespace kaori::shows {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MenuTest : public ::testing::Test {
 protected:
  std::string Taken() {
    const auto taken = menu_.Read(keys_, surface_, lines_, now_);
    return taken ? taken->offer.name : "";
  }
  void Strike(std::uint8_t usage) { board::NotePress(keys_.value, usage, now_); }
  void Show(std::initializer_list<const char*> names) {
    std::vector<Choosable> choices;
    for (const char* name : names)
      choices.push_back({Choosable::Kind::kShow, {.file = name, .name = name}, "1 MB"});
    menu_.Offer(choices);
    menu_.Open(now_);
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
  EXPECT_THAT(menu_.Lines(Message::kChoose, Language::kEnglish, "", "", true),
              ElementsAre(HasSubstr("GO"), "  1. evening  1 MB", "> 2. matinee  1 MB"));
  Strike(board::key::kEnter);
  EXPECT_EQ(Taken(), "matinee");
}

TEST_F(MenuTest, APressFromBeforeTheStickCameTakesNothing) {
  Strike(board::key::kEnter);
  ++lines_.value.pushes[0];
  Show({"evening"});
  EXPECT_EQ(Taken(), "");
}

TEST_F(MenuTest, OpensAndShutsByPageUpAndTakesNothingWhileItIsShut) {
  Show({"evening", "matinee"});
  Strike(board::key::kPageUp);
  EXPECT_EQ(Taken(), "");
  EXPECT_FALSE(menu_.IsOpen(now_));
  Strike(board::key::kEnter);
  board::NotePress(surface_.value, 0, now_);
  ++lines_.value.pushes[0];
  EXPECT_EQ(Taken(), "");
  Strike(board::key::kPageUp);
  Strike(board::key::kDown);
  EXPECT_EQ(Taken(), "");
  Strike(board::key::kEnter);
  EXPECT_EQ(Taken(), "matinee");
}

TEST_F(MenuTest, ShutsWhenNobodyHasPressedAnythingForTwoMinutes) {
  Show({"evening", "matinee"});
  now_ += Menu::kNobodyChooses - 1s;
  Strike(board::key::kDown);
  EXPECT_EQ(Taken(), "");
  now_ += Menu::kNobodyChooses - 1s;
  EXPECT_TRUE(menu_.IsOpen(now_));
  now_ += 1s;
  EXPECT_FALSE(menu_.IsOpen(now_));
  Strike(board::key::kEnter);
  EXPECT_EQ(Taken(), "") << "that was the show's";
}

TEST_F(MenuTest, StaysShutWhereNothingCanBeTaken) {
  menu_.Open(now_);
  Strike(board::key::kPageUp);
  Taken();
  EXPECT_FALSE(menu_.IsOpen(now_));
}

TEST_F(MenuTest, ThatIsShutSaysHowItIsOpened) {
  Show({"evening"});
  EXPECT_THAT(menu_.Lines(Message::kPlays, Language::kEnglish, "evening", "", false),
              ElementsAre("evening: it is on the box and plays now", "  Page Up opens the list of shows"));
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
  fs::create_directories(sys / "class/dm-0/slaves");
  fs::create_directory_symlink(sys / "pci/usb1/1-2/sdb/sdb1", sys / "class/dm-0/slaves/sdb1");
  EXPECT_THAT(FindSticks(sys / "class"), ElementsAre("sdc")) << "the box started from the other one";
  fs::remove_all(sys);
}

}  // namespace
}  // namespace kaori::shows
