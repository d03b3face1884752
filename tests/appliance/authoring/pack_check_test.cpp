// The check of an authoring folder: every fault of every file, all at once, with file, item and reason.
#include "appliance/authoring/pack/check_folder.h"

#include <gmock/gmock.h>

#include "tests/appliance/authoring/checked_folder.h"

namespace kaori::tests {
namespace {

using authoring::CheckFolder;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST_F(CheckedFolder, OfTheDefaultShowHasNoFault) {
  EXPECT_THAT(CheckFolder(show_).faults, IsEmpty());
}

TEST_F(CheckedFolder, NamesTheFaultsOfAllFilesAtOnce) {
  Replace("faces/kaori.toml", "upturn", "upturm");
  Replace("faces/dog.toml", "at = \"grid 0 8\"", "at = \"grid 0 13\"");
  Replace("looks/round.toml", "[lips]", "[lipz]");
  Replace("expressions.toml", "name = \"angry\"", "name = \"smile\"");
  Append("show.toml", "\n[[scene]]\nname = \"lost\"\nface = \"nobody\"\n");
  const auto faults = CheckFolder(show_).faults;
  EXPECT_THAT(faults, Contains(ContainsRegex("faces/kaori.toml:[0-9]+: mouth.upturm: is not known here")));
  EXPECT_THAT(faults, Contains(ContainsRegex("faces/dog.toml:[0-9]+: landmark.*: names no vertex")));
  EXPECT_THAT(faults, Contains(ContainsRegex("looks/round.toml:[0-9]+: lipz: is not known here")));
  EXPECT_THAT(faults, Contains(ContainsRegex("expressions.toml:[0-9]+: .*name: another expression has it")));
  EXPECT_THAT(faults,
              Contains(ContainsRegex("show.toml:[0-9]+: scene \"lost\".face: there is no face \"nobody\"")));
}

TEST_F(CheckedFolder, NamesEveryFaultOfOneFile) {
  Replace("looks/kaori.toml", "[lips]", "[lipz]");
  Replace("looks/kaori.toml", "[lids]", "[lidz]");
  const auto faults = CheckFolder(show_).faults;
  for (const char* item : {"lipz: is not known here", "lidz: is not known here", "lips: ", "lids: "})
    EXPECT_THAT(faults, Contains(HasSubstr(item)));
  EXPECT_THAT(faults, Not(Contains(HasSubstr("lips.colour"))))
      << "what follows from a missing table is not said";
}

TEST_F(CheckedFolder, GoesOnWhereAFileIsMissingOrNoToml) {
  std::filesystem::remove(show_ / "looks/dog.toml");
  Append("faces/cast.toml", "= =\n");
  Append("expressions.toml", "\n[[expression]]\nname = \"new\"\nboth = { NOPOINT = [1, 0, 0] }\n");
  const auto faults = CheckFolder(show_).faults;
  EXPECT_THAT(faults, Contains(ContainsRegex("faces/cast.toml:[0-9]+: ")));
  EXPECT_THAT(faults, Contains(HasSubstr("both.NOPOINT: is no control point")));
  EXPECT_THAT(faults, Not(Contains(HasSubstr("there is no face")))) << "nobody knows which faces there are";
}

TEST_F(CheckedFolder, SaysNothingOfTheScriptThatFollowsFromAFileThatCannotBeRead) {
  Append("expressions.toml", "= =\n");
  Replace("show.toml", "style = \"wire\"", "style = \"oil\"");
  Replace("show.toml", "\"face kaori\"", "\"face karoi\"");
  EXPECT_THAT(CheckFolder(show_).faults,
              ::testing::ElementsAre(ContainsRegex("expressions.toml:[0-9]+: "),
                                     HasSubstr("there is no style \"oil\""),
                                     HasSubstr("button 1: there is no face \"karoi\"")));
}

TEST_F(CheckedFolder, NamesAMissingLookBesideAMissingFace) {
  std::filesystem::remove(show_ / "looks/dog.toml");
  std::filesystem::remove(show_ / "faces/round.toml");
  const auto faults = CheckFolder(show_).faults;
  EXPECT_THAT(faults, Contains(HasSubstr("looks/dog.toml: No such file")));
  EXPECT_THAT(faults, Contains(HasSubstr("faces/round.toml: No such file")));
}

TEST_F(CheckedFolder, NamesAMotionThatWouldJumpEvenBesideABrokenFace) {
  Replace("faces/kaori.toml", "upturn", "upturm");
  Append("show.toml", "\n[[motion]]\nname = \"jump\"\nkey = \"f11\"\nhead_yaw = [[0, 0], [1, 20]]\n");
  EXPECT_THAT(
      CheckFolder(show_).faults,
      Contains(ContainsRegex("show.toml:[0-9]+: motion \"jump\".head_yaw: a curve must start and end at 0")));
}

TEST(CheckFolder, SaysThatThereIsNoSuchFolder) {
  EXPECT_THAT(CheckFolder("/nowhere/at/all").faults,
              ::testing::ElementsAre("/nowhere/at/all: there is no such folder"));
}

}  // namespace
}  // namespace kaori::tests
