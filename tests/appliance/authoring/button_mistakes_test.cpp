// Toggles, buttons that are held, the second sheet, fades of single items and levels of single expressions: what is wrong with
// all of them is said at once, each with file, line and reason.
#include <gmock/gmock.h>

#include "appliance/authoring/pack/check_folder.h"
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
