// The console's page as files, and what it is told of the needles.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hw-sim/console/editor_watch.h"
#include "hw-sim/console/page.h"

namespace kaori::console {
namespace {

using ::testing::HasSubstr;

TEST(ConsolePage, CarriesItsFilesAndNothingElse) {
  ASSERT_NE(FindPageFile("/"), nullptr);
  EXPECT_THAT(std::string(FindPageFile("/")->bytes), HasSubstr("<title>"));
  ASSERT_NE(FindPageFile("/main.js"), nullptr);
  EXPECT_EQ(FindPageFile("/main.js")->content_type, "text/javascript; charset=utf-8");
  EXPECT_EQ(FindPageFile("/../console.cpp"), nullptr);
}

TEST(ConsolePage, AsksNobodyElseForAnything) {
  for (const char* path : {"/", "/style.css", "/main.js", "/wire.js", "/editor.js"}) {
    const std::string text(FindPageFile(path)->bytes);
    EXPECT_EQ(text.find("://"), std::string::npos) << path << " has an address of another machine";
  }
}

TEST(ConsolePage, IsSmall) {
  std::size_t bytes = 0;
  for (const char* path :
       {"/",          "/style.css", "/icon.svg",   "/main.js",   "/wire.js",     "/drag.js",
        "/face.js",   "/dials.js",  "/buttons.js", "/sticks.js", "/keys.js",     "/lips.js",
        "/cables.js", "/editor.js", "/arrows.js",  "/sound.js",  "/switches.js", "/cues.js",
        "/roles.js",  "/check.js",  "/learn.js",   "/takes.js",  "/midi.js",     "/monitor.js"}) {
    ASSERT_NE(FindPageFile(path), nullptr) << path;
    bytes += FindPageFile(path)->bytes.size();
  }
  EXPECT_LT(bytes, 200'000U);
}

// Somebody at the keyboard, and a stage at the screen.
class ConsoleEditorWatch : public ::testing::Test {
 protected:
  void PressTab() {
    Look({.tab_held = true});
    Look({.tab_held = true});
    Look({});
  }
  void Look(EditorWatch::Seen seen) {
    seen.keyboard_heard = heard_;
    seen.screen_drawn = drawn_;
    seen.screen_plugged = plugged_;
    watch_.Follow(seen);
  }

  EditorWatch watch_;
  bool heard_ = true, drawn_ = true, plugged_ = true;
};

TEST_F(ConsoleEditorWatch, AreOpenedAndShutByTab) {
  EXPECT_FALSE(watch_.open());
  PressTab();
  EXPECT_TRUE(watch_.open());
  PressTab();
  EXPECT_FALSE(watch_.open());
}

TEST_F(ConsoleEditorWatch, StayShutWhenNobodyHearsTheKeyboard) {
  heard_ = false;
  PressTab();
  EXPECT_FALSE(watch_.open());
}

TEST_F(ConsoleEditorWatch, AreShutWithANewStage) {
  PressTab();
  drawn_ = false;
  Look({});
  EXPECT_FALSE(watch_.open());
}

TEST_F(ConsoleEditorWatch, StayOpenWhenOnlyTheScreensCableIsPulled) {
  PressTab();
  drawn_ = plugged_ = false;
  Look({});
  plugged_ = true;
  Look({});
  drawn_ = true;
  Look({});
  EXPECT_TRUE(watch_.open());
}

}  // namespace
}  // namespace kaori::console
