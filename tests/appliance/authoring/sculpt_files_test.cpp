// What people write wrongly into a show's files is refused in one line that names file, line, item and
// reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "appliance/authoring/sculpt/sculpt.h"
#include "tests/appliance/authoring/sculpt_fixture.h"

namespace kaori::tests {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

const face::Face& FaceNamed(std::string_view name) {
  const auto& faces = SculptedCast().faces;
  const auto face = std::ranges::find(faces, name, &face::Face::name);
  EXPECT_NE(face, faces.end()) << name;
  return face == faces.end() ? faces.front() : *face;
}

TEST(ShowFiles, OfTheDefaultShowHaveNoFault) {
  EXPECT_EQ(ShowCopy().Complaint(), "");
}

TEST(ShowFiles, AMissingFileIsNamed) {
  ShowCopy show;
  std::filesystem::remove(show.folder() / "faces" / "dog.toml");
  EXPECT_THAT(show.Complaint(), ContainsRegex("dog.toml: No such file"));
}

TEST(ShowFiles, AFolderOrADeviceInPlaceOfAFileIsNamed) {
  const ShowCopy show;
  const auto dog = show.folder() / "faces" / "dog.toml";
  std::filesystem::remove(dog);
  std::filesystem::create_directory(dog);
  EXPECT_THAT(show.Complaint(), ContainsRegex("dog.toml: Is a directory"));
  std::filesystem::remove(dog);
  std::filesystem::create_symlink("/dev/zero", dog);
  EXPECT_THAT(show.Complaint(), ContainsRegex("dog.toml: it is a device, not a file"));
}

TEST(ShowFiles, BrokenTomlIsNamedWithItsLine) {
  ShowCopy show;
  show.Replace("faces/kaori.toml", "radius = 2.2", "radius = = 2.2");
  EXPECT_THAT(show.Complaint(), ContainsRegex("kaori.toml:[0-9]+: "));
}

TEST(ShowFiles, AFaceMayBeNamedOnce) {
  ShowCopy show;
  show.Replace("faces/cast.toml", "\"round\", ", "\"kaori\", \"round\", ");
  EXPECT_THAT(show.Complaint(), ContainsRegex("cast.toml:[0-9]+: faces: \"kaori\" is given twice"));
}

TEST(ShowFiles, AMisspeltKeyIsNotPassedOver) {
  ShowCopy show;
  show.Replace("faces/kaori.toml", "upturn", "upturm");
  EXPECT_THAT(show.Complaint(), ContainsRegex("kaori.toml:[0-9]+: mouth.upturm: is not known here"));
}

TEST(ShowFiles, AMissingNumberIsNamed) {
  ShowCopy show;
  show.Replace("faces/round.toml", "half_width = 1.75\n", "");
  EXPECT_THAT(show.Complaint(), ContainsRegex("round.toml:[0-9]+: mouth.half_width: is missing"));
}

TEST(ShowFiles, AWordInPlaceOfANumberIsNamed) {
  ShowCopy show;
  show.Replace("faces/narrator.toml", "half_width = 2.5", "half_width = \"wide\"");
  EXPECT_THAT(show.Complaint(), HasSubstr("mouth.half_width: must be a number"));
}

TEST(ShowFiles, StepsOfSmoothingAreBounded) {
  ShowCopy show;
  show.Replace("faces/dog.toml", "smoothing_steps = 6", "smoothing_steps = 1e18");
  EXPECT_THAT(show.Complaint(),
              ContainsRegex("smoothing_steps: is 1e.18, and must be a whole number from 0 to 1000"));
}

TEST(ShowFiles, NoNumberMayBeInfinite) {
  ShowCopy show;
  show.Replace("faces/dog.toml", "radius = 2\n", "radius = inf\n");
  EXPECT_THAT(show.Complaint(), ContainsRegex("dog.toml:[0-9]+: a number that is not finite"));
}

TEST(ShowFiles, ALandmarkMustNameAVertex) {
  ShowCopy show;
  show.Replace("faces/dog.toml", "at = \"grid 0 8\"", "at = \"grid 0 13\"");
  EXPECT_THAT(show.Complaint(), HasSubstr("landmark[1].at: names no vertex"));
}

TEST(ShowFiles, TwoLandmarksMayNotPullTheSameVertex) {
  ShowCopy show;
  show.Replace("faces/dog.toml", "at = \"grid 0 11\"", "at = \"grid 0 8\"");
  EXPECT_THAT(show.Complaint(), HasSubstr("dog.toml: landmarks: two of them pull the same point"));
}

TEST(ShowFiles, AFaceThatIsLikeAnotherTakesFromThereWhatItDoesNotSay) {
  const face::Face& kaori = FaceNamed("kaori");
  const face::Face& poster = FaceNamed("poster");  // Says nothing of its own.
  EXPECT_EQ(poster.positions, kaori.positions);
  const face::Face& mask = FaceNamed("mask");  // Other lids, the same ball.
  EXPECT_EQ(mask.eyes[0].centre, kaori.eyes[0].centre);
  EXPECT_NE(mask.positions, kaori.positions);
}

TEST(ShowFiles, AFaceMayBeLikeOneThatStandsOnItsOwnAlone) {
  for (const char* other : {"mask", "dog", "nobody"}) {
    ShowCopy show;
    show.Replace("faces/poster.toml", "like = \"kaori\"", std::string("like = \"") + other + "\"");
    EXPECT_THAT(show.Complaint(), HasSubstr("poster.toml:3: like: must name a valid, carved face")) << other;
  }
}

TEST(ShowFiles, EdgesOfABoxAreRoundedWithinIt) {
  ShowCopy show;
  show.Replace("faces/robot.toml", "rounding = 4", "rounding = 8");
  EXPECT_THAT(show.Complaint(), HasSubstr("rounding: must lie between 0 and the least of 'half'"));
}

TEST(ShowFiles, ATubeNeedsItsSixStations) {
  ShowCopy show;
  show.Replace("faces/kettle.toml", "half_thickness = [1, ", "half_thickness = [");
  EXPECT_THAT(show.Complaint(), HasSubstr("handle.half_thickness: must have 6 entries"));
}

TEST(ShowFiles, RowsOfTheAimTableMustRise) {
  ShowCopy show;
  show.Replace("faces/cast.toml", "row = 16", "row = 14");
  EXPECT_THAT(show.Complaint(), HasSubstr("aim.rows: must be two numbers or more that rise"));
}

TEST(ShowFiles, AnExpressionMayOnlyMovePointsThatExist) {
  ShowCopy show;
  show.Replace("expressions.toml", "MC = [0.66,", "MX = [0.66,");
  EXPECT_THAT(show.Complaint(),
              ContainsRegex("expressions.toml:[0-9]+: expression.[0-9]+..both.MX: is no control point"));
}

TEST(ShowFiles, AnExpressionMayOnlyBuildOnEarlierOnes) {
  ShowCopy show;
  show.Replace("expressions.toml", "from = { smile = 1.1,", "from = { wink = 1.1,");
  EXPECT_THAT(show.Complaint(), HasSubstr("from.wink: is no expression written before this one"));
}

TEST(ShowFiles, TheFirstExpressionIsTheFaceAtRest) {
  ShowCopy show;
  show.Replace("expressions.toml", "name = \"neutral\"", "name = \"calm\"");
  EXPECT_THAT(show.Complaint(), HasSubstr("expression: the first one must be \"neutral\""));
}

TEST(ShowFiles, NamesOfExpressionsMustDiffer) {
  ShowCopy show;
  show.Replace("expressions.toml", "name = \"angry\"", "name = \"smile\"");
  EXPECT_THAT(show.Complaint(), HasSubstr("name: another expression has it already"));
}

TEST(ShowFiles, LidsShutByAFraction) {
  ShowCopy show;
  show.Replace("expressions.toml", "lids = [1, 0]", "lids = [2, 0]");
  EXPECT_THAT(show.Complaint(), HasSubstr("lids: must be two numbers from 0"));
}

TEST(ShowFiles, AFaultLeavesTheCastAsItWas) {
  ShowCopy show;
  show.Replace("expressions.toml", "name = \"neutral\"", "name = \"calm\"");
  face::Cast cast;
  cast.faces.resize(3);
  EXPECT_FALSE(sculpt::Sculpt(show.folder(), cast));
  EXPECT_EQ(cast.faces.size(), 3U);
}

}  // namespace
}  // namespace kaori::tests
