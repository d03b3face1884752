// Toggles, buttons that are held, those of sticks, the second sheet, fades of single items and levels of single expressions: what is wrong with
// all of them is said at once, each with file, line and reason.
#include <gmock/gmock.h>

#include <algorithm>

#include "appliance/authoring/pack/check_folder.h"
#include "appliance/authoring/script/show_file.h"
#include "tests/appliance/authoring/checked_folder.h"

namespace kaori::tests {
namespace {

using authoring::CheckFolder;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::IsEmpty;

using ButtonsOfAShow = CheckedFolder;

TEST_F(ButtonsOfAShow, AreRefusedAllAtOnceWithFileLineAndReason) {
  Replace("show.toml", "\"face kaori\"", "\"toggle scene night\"");
  Replace("show.toml", "\"face poster\"", "\"momentary face pestor\"");
  Replace("show.toml", "q = \"style wire\"", "q = \"sheet 3\"");
  Replace("show.toml", "\"style wire\", \"style flat\",", "\"style wire\",");
  Replace("show.toml", "[keys]",
          "[fades]\n\"face karoi\" = { in_s = 1 }\n\"style wire\" = { in_s = 1 }\n"
          "\"face dog\" = { out_s = 9000, curve = \"x\" }\n[keys]");
  Replace("roles.toml", "level = \"head_lean\"", "level = \"expression smlie\"");
  const auto faults = CheckFolder(show_).faults;
  for (const char* says :
       {"show.toml:[0-9]+: button 1: \"toggle\" is for faces, expressions and sheets",
        "show.toml:[0-9]+: button 2: there is no face \"pestor\"; did you mean \"poster\"[?]",
        "show.toml:[0-9]+: keys.q: there is no sheet \"3\", but 1 and 2",
        "show.toml:[0-9]+: second_buttons: 31 are given; the box has 32",
        "show.toml:[0-9]+: fades.face karoi: there is no face \"karoi\"; did you mean \"kaori\"[?]",
        "show.toml:[0-9]+: fades.style wire: is none of \"face ...\" and \"expression ...\"",
        "show.toml:[0-9]+: fades.face dog.out_s: is 9000 s, not within 0 to 1800",
        "show.toml:[0-9]+: fades.face dog.curve: \"x\" is none of s, linear, slow start, slow end",
        "roles.toml:[0-9]+: role \"head\".map.4..level: there is no expression \"smlie\"; did you"})
    EXPECT_THAT(faults, Contains(ContainsRegex(says)));
}

TEST_F(ButtonsOfAShow, JumpToCuesAndBlinkAndStandOnSticksToo) {
  Replace("show.toml", "\"face kaori\"", "\"cue 2\"");
  Replace("show.toml", "q = \"style wire\"", "q = \"wink left\"");
  Append("roles.toml",
         "[[button]]\ndevice = \"left stick\"\nnumber = 1\ncall = \"blink\"\n"
         "[[button]]\ndevice = \"right stick\"\nnumber = 16\ncall = \"momentary expression smile\"\n"
         "[[button]]\ndevice = \"right stick\"\nnumber = 2\ncall = \"cue go\"\n");
  show::Show show;  // Without its cast, whose names are all taken for right then.
  ASSERT_THAT(authoring::ReadShowFile(show_ / "show.toml", show, {.faces = false, .expressions = false}),
              IsEmpty());
  using show::CallKind;
  EXPECT_EQ(show.buttons[0].kind, CallKind::kGoTo);
  EXPECT_EQ(show.cue_list.cues.at(show.buttons[0].index).number, "2");
  const auto is_q = [](const show::KeyCall& key) { return key.key_usage == 0x14; };
  EXPECT_EQ(std::ranges::find_if(show.keys, is_q)->call, (show::Call{CallKind::kBlink, 1}));
  EXPECT_EQ(show.stick_buttons[0], (show::Call{CallKind::kBlink, 0}));
  EXPECT_EQ(show.stick_buttons[show::kStickButtonCount + 15].kind, CallKind::kExpression);
  EXPECT_EQ(show.stick_buttons[show::kStickButtonCount + 15].mode, show::CallMode::kMomentary);
  EXPECT_EQ(show.stick_buttons[show::kStickButtonCount + 1], (show::Call{CallKind::kCue, 0}));
  EXPECT_THAT(CheckFolder(show_).faults, IsEmpty());
}

TEST_F(ButtonsOfAShow, OfTheSticksAreRefusedAllAtOnceWithFileLineAndReason) {
  Replace("show.toml", "\"face kaori\"", "\"cue 2.55\"");
  Replace("show.toml", "q = \"style wire\"", "q = \"wink up\"");
  Append("roles.toml",
         "[[button]]\nnumber = 4\ncall = \"blink\"\n"
         "[[button]]\ndevice = \"left stick\"\nnumber = 17\ncall = \"blink\"\n"
         "[[button]]\ndevice = \"left stick\"\nnumber = 3\n"
         "[[button]]\ndevice = \"left stick\"\nnumber = 4\ncall = \"toggle cue go\"\n"
         "[[button]]\ndevice = \"left stick\"\nnumber = 4\ncall = \"face karoi\"\n"
         "[[button]]\ndevice = \"third stick\"\nnumber = 5\ncal = \"blink\"\n");
  const auto faults = CheckFolder(show_).faults;
  for (const char* says :
       {"show.toml:[0-9]+: button 1: there is no cue \"2.55\"",
        "show.toml:[0-9]+: keys.q: \"wink up\" is none of blink, wink left, wink right",
        "roles.toml:[0-9]+: button.1..device: must be a stick: buttons of the dial box stand in show.toml",
        "roles.toml:[0-9]+: button.2..number: is 17, and must be a whole number from 1 to 16",
        "roles.toml:[0-9]+: button.3..call: is missing",
        "roles.toml:[0-9]+: button.4..call: \"toggle\" is for faces, expressions and sheets",
        "roles.toml:[0-9]+: button.5..call: there is no face \"karoi\"; did you mean \"kaori\"[?]",
        "roles.toml:[0-9]+: button.5..number: button 4 is given twice",
        "roles.toml:[0-9]+: button.6..device: \"third stick\" is none of left stick, right stick, dial box",
        "roles.toml:[0-9]+: button.6..cal: is not known here; did you mean \"call\"[?]"})
    EXPECT_THAT(faults, Contains(ContainsRegex(says)));
}

TEST_F(ButtonsOfAShow, MayJumpToNoCueWhereThereIsNoList) {
  std::filesystem::remove(show_ / "cues.toml");
  std::filesystem::remove(show_ / "lobby.toml");
  Replace("show.toml", "\"face kaori\"", "\"cue 2\"");
  EXPECT_THAT(CheckFolder(show_).faults,
              Contains(ContainsRegex("button 1: there is no cue \"2\": the show has no cues.toml")));
}

TEST_F(ButtonsOfAShow, MayToggleBeHeldAndFadeForMinutes) {
  Replace("show.toml", "\"face kaori\"", "\"toggle face kaori\"");
  Replace("show.toml", "[keys]",
          "[fades]\n\"face dog\" = { in_s = 0, out_s = 600, curve = \"slow end\" }\n[keys]");
  Replace("roles.toml", "level = \"head_lean\"", "level = \"expression smile\"");
  Append("cues.toml", "release = [\"expression smile\"]\n");
  EXPECT_THAT(CheckFolder(show_).faults, IsEmpty());
}

}  // namespace
}  // namespace kaori::tests
