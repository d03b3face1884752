// What the status picture is told of a box, by files in memory.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "appliance/programs/status/facts.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::status {
namespace {

TEST(StatusFacts, AreWhatTheBoxWasToldAndNothingWhereItWasToldNothing) {
  const board::BoardFile place;
  Places places{place.folder(), place.folder() / "screens"};
  places.update = place.folder() / "notice";
  places.spoilt = place.folder() / "spoilt";
  places.usb = place.folder() / "usb";
  EXPECT_EQ(ReadFacts(places), Facts());
  for (const auto& [file, text] : {std::pair{"kiosk", ""},
                                   {"root_hash", "abc"},
                                   {"slot", "B"},
                                   {"status_screen", "HDMI-A-2"},
                                   {"monitor_screen", "3"},
                                   {"faults", "one\n\ntwo\n"},
                                   {"notice", "it is tried\n試しています\n"},
                                   {"spoilt", "its copy plays\n控えで上演中\n"},
                                   {"screens", "HDMI-A-1 640x480 60 wanted picture\n"}})
    std::ofstream(place.folder() / file) << text;
  const Facts facts = ReadFacts(places);
  EXPECT_EQ(facts.profile, "kiosk");
  EXPECT_EQ(facts.root_hash + facts.slot, "abcB");
  EXPECT_EQ(facts.screen, "HDMI-A-2");
  EXPECT_EQ(facts.monitor, "3");
  EXPECT_EQ(facts.faults, (std::vector<std::string>{"one", "two", "its copy plays", "控えで上演中"}));
  EXPECT_EQ(facts.update, (std::vector<std::string>{"it is tried", "試しています"}));
  EXPECT_EQ(facts.screens.size(), 1U);
}

// Two boxes that were set up from one stick may have one name.
TEST(StatusFacts, NameABoxByItsNumberToo) {
  const board::BoardFile place;
  const auto name_of = [&](const char* name) {
    std::ofstream(place.folder() / "name") << name << "\n";
    return ReadFacts({place.folder(), place.folder() / "screens"}).name;
  };
  EXPECT_EQ(name_of("left-lobby"), "left-lobby") << "a box that keeps nothing has no number";
  std::ofstream(place.folder() / "machine-id") << "1a2b3c4d5e6f00112233445566778899\n";
  EXPECT_EQ(name_of("left-lobby"), "left-lobby (1a2b3c4d)");
  EXPECT_EQ(name_of("kaori-1a2b3c4d"), "kaori-1a2b3c4d") << "it has been told already";
}

TEST(StatusFacts, NameADeviceThatStaysOutUntilItsFileGoes) {
  const board::BoardFile place;
  Places places{place.folder(), place.folder() / "screens"};
  places.usb = place.folder() / "usb";
  std::filesystem::create_directories(places.usb);
  for (const auto& [port, text] :
       {std::pair{"1-1", ""},
        {"1-2",
         "fault\nUSB port 1-2: a storage device that also calls itself a keyboard stays out\nキーボード\n"},
        {"1-3", "quiet\nUSB port 1-3: a telephone\n電話機\n"},
        {"1-4", "named\nUSB port 1-4: a storage device\n記憶装置\n"},
        {"1-5", "named\nUSB port 1-5: a torn file"}})
    std::ofstream(places.usb / port) << text;
  const Facts facts = ReadFacts(places);
  EXPECT_EQ(facts.faults,
            (std::vector<std::string>{
                "USB port 1-2: a storage device that also calls itself a keyboard stays out", "キーボード"}));
  EXPECT_EQ(facts.usb, (std::vector<std::string>{"USB port 1-4: a storage device", "記憶装置",
                                                 "USB port 1-5: a torn file"}));
  for (const char* port : {"1-2", "1-4", "1-5"}) std::filesystem::remove(places.usb / port);
  EXPECT_EQ(ReadFacts(places), Facts());
}

}  // namespace
}  // namespace kaori::status
