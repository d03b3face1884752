// The console without a browser: lines of hands, who may come in, pictures, and what the page is told.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include "hw-sim/console/guard.h"
#include "hw-sim/console/hands.h"
#include "hw-sim/console/jpeg.h"
#include "hw-sim/console/page.h"
#include "hw-sim/console/rate.h"
#include "hw-sim/console/words.h"

namespace kaori::console {
namespace {

using sim::Hand;
using sim::Place;
using sim::Verb;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string Refused(std::string_view lines) {
  const auto hands = ParseHands(lines);
  return hands ? "taken" : hands.error().attempt;
}

TEST(ConsoleHands, AreReadFromLines) {
  const auto hands = ParseHands(
      "dial 1 turn 0.25\nbutton 32 push\n\nstick left move -1 0.5\nstick right twist 1\nstick left slide "
      "0.75\n"
      "stick right hat 7\nstick right hat centre\nstick left push 12\nkey 44 press\nkey 44 release\n"
      "lips 0.9 1.2\nlens cover\ncable camera pull\n");
  ASSERT_TRUE(hands) << hands.error().message();
  EXPECT_THAT(
      *hands,
      ElementsAre(Hand{Place::kDialBox, Verb::kTurn, 0, 0.25}, Hand{Place::kDialBox, Verb::kPush, 31},
                  Hand{Place::kStickLeft, Verb::kMove, 0, -1, 0.5},
                  Hand{Place::kStickRight, Verb::kTwist, 0, 1},
                  Hand{Place::kStickLeft, Verb::kSlide, 0, 0.75}, Hand{Place::kStickRight, Verb::kHat, 7},
                  Hand{Place::kStickRight, Verb::kHat, -1}, Hand{Place::kStickLeft, Verb::kPush, 11},
                  Hand{Place::kKeyboard, Verb::kPush, 44}, Hand{Place::kKeyboard, Verb::kRelease, 44},
                  Hand{Place::kCamera, Verb::kLips, 0, 0.9, 1.2}, Hand{Place::kCamera, Verb::kCoverLens, 1},
                  Hand{Place::kCamera, Verb::kUnplug}));
}

TEST(ConsoleHands, AreNoneInAnEmptyMessage) {
  const auto hands = ParseHands("\n  \n");
  ASSERT_TRUE(hands);
  EXPECT_THAT(*hands, IsEmpty());
}

TEST(ConsoleHands, NameTheLineAndTheLimitOfABadOne) {
  EXPECT_EQ(Refused("dial 1 turn 0\ndial 9 turn 1"), "line 2: the dial is '9': it goes from 1 to 8");
  EXPECT_THAT(Refused("dial 0 turn 1"), HasSubstr("from 1 to 8"));
  EXPECT_THAT(Refused("dial 1.5 turn 1"), HasSubstr("whole number"));
  EXPECT_THAT(Refused("dial 1 turn 5"), HasSubstr("from -4 to 4"));
  EXPECT_THAT(Refused("dial 1 push"), HasSubstr("can only turn"));
  EXPECT_THAT(Refused("button 33 push"), HasSubstr("from 1 to 32"));
  EXPECT_THAT(Refused("button 3 hold"), HasSubstr("'hold' is neither push nor release"));
  EXPECT_THAT(Refused("stick middle move 0 0"), HasSubstr("neither left nor right"));
  EXPECT_THAT(Refused("stick left move 0 1.01"), HasSubstr("y is '1.01'"));
  EXPECT_THAT(Refused("stick left fly"), HasSubstr("cannot 'fly'"));
  EXPECT_THAT(Refused("stick left hat 8"), HasSubstr("from 0 to 7"));
  EXPECT_THAT(Refused("key 3 press"), HasSubstr("from 4 to 231"));
  EXPECT_THAT(Refused("lips 1"), HasSubstr("width is ''"));
  EXPECT_THAT(Refused("cable toaster plug"), HasSubstr("no device is called 'toaster'"));
  EXPECT_THAT(Refused("kettle 1"), HasSubstr("'kettle' is no part of the console"));
  EXPECT_THAT(Refused("lens cover twice"), HasSubstr("'twice' is one word too many"));
}

TEST(ConsoleHands, AreNeverNumbersThatAreNone) {
  for (const char* number : {"nan", "inf", "-inf", "1e999", "0x1", "1,5", "", "--1", "1 1"})
    EXPECT_NE(Refused(std::string("dial 1 turn ") + number), "taken") << number;
}

TEST(ConsoleHands, AllStayStillWhenOneLineIsWrong) {
  EXPECT_FALSE(ParseHands("dial 1 turn 1\nbutton 40 push\ndial 2 turn 1"));
}

TEST(ConsoleGuard, LetsInThePagesItServed) {
  EXPECT_FALSE(Refusal({.host = "127.0.0.1:8080"}));
  EXPECT_FALSE(
      Refusal({.host = "localhost:8080", .origin = "http://localhost:8080", .fetch_site = "same-origin"}));
  EXPECT_FALSE(Refusal({.host = "127.0.0.1", .fetch_site = "none"}));
}

TEST(ConsoleGuard, KeepsOutNamesThatAreNotThisMachine) {
  for (const char* host : {"", "example.org", "127.0.0.1.example.org", "localhost.example.org:80",
                           "127.0.0.1:80@x", "192.168.0.2:8080", "0.0.0.0:8080", "[::1]:8080"})
    EXPECT_TRUE(Refusal({.host = host})) << host;
}

TEST(ConsoleGuard, KeepsOutPagesOfOtherSites) {
  const std::string_view host = "127.0.0.1:8080";
  for (const char* origin : {"http://example.org", "http://127.0.0.1:8081", "https://127.0.0.1:8080", "null",
                             "http://127.0.0.1:8080.example.org", "http://localhost:8080"})
    EXPECT_TRUE(Refusal({.host = host, .origin = origin})) << origin;
  for (const char* site : {"cross-site", "same-site"})
    EXPECT_TRUE(Refusal({.host = host, .fetch_site = site})) << site;
}

// Two rows: the lower one red, the upper one blue; 16 columns and rows a colour, so that JPEG keeps them
// apart.
std::vector<std::uint8_t> RedBelowBlue() {
  std::vector<std::uint8_t> rgbx;
  for (int pixel = 0; pixel < 32 * 32; ++pixel) {
    const bool lower = pixel < 32 * 16;
    const std::uint8_t red = lower ? 255 : 0;
    const std::uint8_t blue = lower ? 0 : 255;
    rgbx.insert(rgbx.end(), {red, 0, blue, 0});
  }
  return rgbx;
}

TEST(ConsolePicture, HasItsTopAtTheTop) {
  JpegEncoder encoder;
  const auto jpeg = encoder.Encode({32, 32, RedBelowBlue()}, 95);
  ASSERT_TRUE(jpeg) << jpeg.error().message();
  std::vector<std::uint8_t> rgb(32 * 32 * 3);
  tjhandle decoder = tjInitDecompress();
  ASSERT_EQ(tjDecompress2(decoder, reinterpret_cast<const unsigned char*>(jpeg->data()), jpeg->size(),
                          rgb.data(), 32, 0, 32, TJPF_RGB, 0),
            0);
  tjDestroy(decoder);
  EXPECT_GT(rgb[2], 200) << "the first row that a browser shows is the upper one";
  EXPECT_GT(rgb[32 * 31 * 3], 200);
}

TEST(ConsolePicture, IsRefusedWhenItsSizeLies) {
  JpegEncoder encoder;
  const auto rgbx = RedBelowBlue();
  EXPECT_FALSE(encoder.Encode({32, 33, rgbx}, 85));
  EXPECT_FALSE(encoder.Encode({0, 0, {}}, 85));
  EXPECT_FALSE(encoder.Encode({-32, -32, rgbx}, 85));
}

TEST(ConsoleWords, KeepLabelsWithQuotesAndBrokenTextWhole) {
  Labels labels;
  labels.buttons[0] = {"\"Kaori\" \xE3\x82\xAB", "face"};
  labels.dials[0] = "torn \xE3\x82";
  const auto json = LabelsJson(labels);
  EXPECT_THAT(json, HasSubstr("\\\"Kaori\\\" \xE3\x82\xAB"));
  EXPECT_THAT(json, HasSubstr("torn \xEF\xBF\xBD"));
}

TEST(ConsolePage, CarriesItsFilesAndNothingElse) {
  ASSERT_NE(FindPageFile("/"), nullptr);
  EXPECT_THAT(std::string(FindPageFile("/")->bytes), HasSubstr("<title>"));
  ASSERT_NE(FindPageFile("/main.js"), nullptr);
  EXPECT_EQ(FindPageFile("/main.js")->content_type, "text/javascript; charset=utf-8");
  EXPECT_EQ(FindPageFile("/../console.cpp"), nullptr);
}

TEST(ConsolePage, AsksNobodyElseForAnything) {
  for (const char* path : {"/", "/style.css", "/main.js", "/wire.js"}) {
    const std::string text(FindPageFile(path)->bytes);
    EXPECT_EQ(text.find("://"), std::string::npos) << path << " has an address of another machine";
  }
}

TEST(ConsoleRate, IsCountedOverASecond) {
  Rate rate;
  const Time start = Time{} + std::chrono::seconds(5);
  rate.See(100, start);
  EXPECT_EQ(rate.per_s(), 0) << "one look is no rate";
  rate.See(130, start + std::chrono::milliseconds(500));
  EXPECT_EQ(rate.per_s(), 0);
  rate.See(160, start + std::chrono::seconds(1));
  EXPECT_EQ(rate.per_s(), 60);
}

}  // namespace
}  // namespace kaori::console
