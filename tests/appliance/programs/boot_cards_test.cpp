// Which of several graphics cards shows, as the kernel lists them, and who may use them all.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/programs/boot/card.h"
#include "drivers/base/graphics_cards.h"

namespace kaori {
namespace {

namespace fs = std::filesystem;

class ListedCards : public ::testing::Test {
 protected:
  ListedCards() : folder_(fs::path(::testing::TempDir()) / ("cards-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~ListedCards() override { fs::remove_all(folder_); }

  const fs::path& folder() const { return folder_; }
  void List(std::initializer_list<const char*> names) const {
    for (const char* name : names) fs::create_directory(folder_ / name);
  }

 private:
  fs::path folder_;
};

// A Raspberry Pi 4, where v3d was there first: its vc4 shows.
TEST_F(ListedCards, TheOneWithSocketsForScreensShowsWhereAnotherOnlyDraws) {
  List({"card0", "card1", "card1-HDMI-A-1", "card1-HDMI-A-2", "card1-Writeback-1", "renderD128", "version"});
  EXPECT_EQ(CardWithScreens(folder()), "card1");
}

TEST_F(ListedCards, OnAPcItIsTheFirstOne) {
  List({"card0", "card0-HDMI-A-1", "card0-VGA-1", "renderD128", "version"});
  EXPECT_EQ(CardWithScreens(folder()), "card0");
}

TEST_F(ListedCards, OfSeveralWithScreensTheLowestNumberIsTaken) {
  List({"card10", "card10-DP-1", "card2", "card2-DP-1", "card9", "card9-HDMI-A-1"});
  EXPECT_EQ(CardWithScreens(folder()), "card2");
}

TEST_F(ListedCards, WithoutAConnectorThereIsNone) {
  List({"card0", "renderD128", "version", "cardigan-1", "card-1", "card1x-DP-1"});
  EXPECT_EQ(CardWithScreens(folder()), std::nullopt);
  EXPECT_EQ(CardWithScreens(folder() / "nowhere"), std::nullopt);
}

TEST(CardFile, ThatIsNamedIsTaken) {
  EXPECT_EQ(CardFile("/dev/dri/card7"), "/dev/dri/card7");
  EXPECT_NE(CardFile(kCardWithScreens), kCardWithScreens);
}

TEST_F(ListedCards, EachIsGivenToItsGroupAndNothingElseIs) {
  constexpr mode_t kOwnerAlone = 0600;
  for (const char* name : {"card0", "card1", "renderD128", "renderD129", "another"}) {
    std::ofstream(folder() / name).flush();
    ::chmod((folder() / name).c_str(), kOwnerAlone);
  }
  boot::GiveCards(folder(), ::getgid(), ::getgid());
  const auto mode = [&](const char* name) { return fs::status(folder() / name).permissions(); };
  for (const char* name : {"card0", "card1", "renderD128", "renderD129"})
    EXPECT_EQ(mode(name), static_cast<fs::perms>(0660)) << name;
  EXPECT_EQ(mode("another"), static_cast<fs::perms>(kOwnerAlone));
}

}  // namespace
}  // namespace kaori
