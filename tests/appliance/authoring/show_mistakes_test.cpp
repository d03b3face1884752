// What makers of shows get wrong, one mistake at a time: each is refused, with file, line and a reason that
// says what to do.
#include <gmock/gmock.h>

#include <ostream>

#include "appliance/authoring/pack/check_folder.h"
#include "tests/appliance/authoring/checked_folder.h"
#include "tests/appliance/authoring/cue_mistakes.h"

namespace kaori::tests {
namespace {

using authoring::CheckFolder;
using ::testing::Contains;
using ::testing::ContainsRegex;

const Mistake kInTheScript[] = {
    {"ButtonOfNoFace", "show.toml", "face kaori\"", "face karoi\"",
     "show.toml:[0-9]+: button 1: there is no face \"karoi\"; did you mean \"kaori\"[?]"},
    {"ButtonOfNoKind", "show.toml", "\"face kaori\"", "\"fcae kaori\"",
     "show.toml:[0-9]+: button 1: \"fcae\" is none of face, expression, style, scene, cue, sheet, take, "
     "motion, blink, wink; did "
     "you mean \"face\"[?]"},
    {"ButtonTooFew", "show.toml", "\"expression sleepy\"", "",
     "show.toml:[0-9]+: buttons: 31 are given; the box has 32"},
    {"SceneOfNoExpression", "show.toml", "expression = \"smile\"", "expression = \"smlie\"",
     "show.toml:[0-9]+: scene \"poster\".expression: there is no expression \"smlie\"; did you mean "
     "\"smile\"[?]"},
    {"SceneOfNoStyle", "show.toml", "style = \"wire\"", "style = \"wires\"",
     "show.toml:[0-9]+: scene \"stage\".style: there is no style \"wires\"; styles are wire, flat"},
    {"SceneOfANameThatIsTaken", "show.toml", "name = \"kitchen\"", "name = \"poster\"",
     "show.toml:[0-9]+: scene \"poster\".name: the name \"poster\" is given twice"},
    {"KeyUsedTwice", "show.toml", "key = \"f2\"", "key = \"f1\"",
     "show.toml:[0-9]+: scene \"poster\".key: the key \"f1\" is given twice: it is that of scene \"studio\" "
     "in line [0-9]+"},
    {"KeyOfAMotionUsedTwice", "show.toml", "key = \"4\"", "key = \"3\"",
     "show.toml:[0-9]+: motion \"laugh\".key: the key \"3\" is given twice: it is that of motion \"look "
     "around\""},
    {"KeyThatWinks", "show.toml", "key = \"9\"", "key = \"z\"",
     "scene \"night\".key: the key \"z\" belongs to the box: it winks"},
    {"KeyThatWinksTheOtherEye", "show.toml", "q = \"style wire\"", "x = \"style wire\"",
     "show.toml:[0-9]+: keys.x: the key \"x\" belongs to the box: it winks"},
    {"KeyOfTheEditor", "show.toml", "key = \"9\"", "key = \"m\"",
     "scene \"night\".key: the key \"m\" belongs to the box: the expression editor uses it"},
    {"KeyOfTheCalibration", "show.toml", "key = \"f10\"", "key = \"f12\"",
     "scene \"fair\".key: the key \"f12\" belongs to the box: it begins the calibration of the lips"},
    {"KeyThatIsNone", "show.toml", "key = \"f10\"", "key = \"f13\"",
     "show.toml:[0-9]+: scene \"fair\".key: there is no key \"f13\"; keys are a to z, 0 to 9, f1 to f12, "
     "enter"},
    {"FormerWord", "show.toml", "", "[[take]]\nname = \"wave\"\nlids = [[0, 0], [1, 0]]\n",
     "show.toml:[0-9]+: take: a registered motion is now written \\[\\[motion\\]\\]"},
    {"TableThatIsNone", "show.toml", "", "[[sceen]]\nname = \"b\"\n",
     "show.toml:[0-9]+: sceen: is not known here; did you mean \"scene\"[?]"},
    {"TurnTooFar", "show.toml", "[0.2, 14]", "[0.2, 1200]",
     "show.toml:[0-9]+: motion \"shake\".head_yaw: 1200 degrees, and 229 to either side are the most"},
    {"MotionThatJumps", "show.toml", "[0.9, 0]]", "[0.9, 5]]",
     "show.toml:[0-9]+: motion \"nod\".head_pitch: a curve must start and end at 0"},
    {"MotionOfTimesThatFall", "show.toml", "[0.38, 3]", "[0.08, 3]",
     "show.toml:[0-9]+: motion \"nod\".head_pitch: second 0.08 must lie after second 0.18"},
    {"MotionOfNoChannel", "show.toml", "jaw_open = [[0", "jaw_opne = [[0",
     "motion \"laugh\".jaw_opne: there is no target or channel \"jaw_opne\"; did you mean \"jaw_open\"[?]"},
    {"SoundThatIsMissing", "show.toml", "name = \"nod\"", "name = \"nod\"\nsound = \"hello.wav\"",
     "show.toml:[0-9]+: motion \"nod\".sound: read .*hello.wav: No such file"},
    {"FadeInMilliseconds", "show.toml", "fade_s = 1.2", "fade_s = 1200",
     "show.toml:[0-9]+: scene \"poster\".fade_s: is 1200 s, not within 0 to 60"},
    {"LightInPercent", "show.toml", "light = 0.72", "light = 72",
     "show.toml:[0-9]+: scene \"night\".light: is 72, not within 0 to 4"},
    {"BackdropThatIsMissing", "show.toml", "backdrop = { kind = \"rays\"", "backdrob = { kind = \"rays\"",
     "show.toml:[0-9]+: scene \"poster\".backdrop: is missing, such as"},
    {"BackdropOfNoKind", "show.toml", "kind = \"studio\"", "kind = \"studoi\"",
     "show.toml:[0-9]+: scene \"studio\".backdrop.kind: there is no kind \"studoi\"; kinds are gradient, "
     "studio"},
    {"PictureThatIsMissing", "show.toml", "{ kind = \"pine\",", "{ picture = \"attic.png\",",
     "show.toml:[0-9]+: scene \"noh\".backdrop.picture: .*attic.png: No such file"},
    {"ChannelOfNoExpression", "show.toml", "lids_up = \"lids_up\"", "lids_up = \"lid_up\"",
     "show.toml:[0-9]+: channels.lids_up: there is no expression \"lid_up\"; did you mean \"lids_up\"[?]"},
};

const Mistake kInTheGaze[] = {
    {"TargetOfTwoNumbers", "show.toml", "\"seat 12\" = [-2.4, -1.2, 6]", "\"seat 12\" = [-2.4, -1.2]",
     "show.toml:[0-9]+: gaze.seat 12: must be three numbers"},
    {"TargetBehindHer", "show.toml", "[-2.4, -1.2, 6]", "[-2.4, -1.2, -6]",
     "show.toml:[0-9]+: gaze.seat 12: is no place before her: .left, up, to the audience. in metres"},
    {"TargetInCentimetres", "show.toml", "[-2.4, -1.2, 6]", "[-240, -120, 600]",
     "show.toml:[0-9]+: gaze.seat 12: is no place before her: .* 0.4 to 200 m away"},
    {"TargetThatIsNobody", "show.toml",
     "\"seat 12\" =", "nobody =", "show.toml:[0-9]+: gaze.nobody: means that she looks at nobody"},
    {"SceneOfNoTarget", "show.toml", "fade_s = 0.8\n", "fade_s = 0.8\ngaze = \"hause\"\n",
     "show.toml:[0-9]+: scene \"studio\".gaze: there is no gaze target \"hause\"; did you mean \"house\"[?]"},
    {"SceneOfLifeInPercent", "show.toml", "fade_s = 0.8\n", "fade_s = 0.8\nlife = { blink = 40 }\n",
     "show.toml:[0-9]+: scene \"studio\".life.blink: is 40, not within 0 to 2"},
    {"CueOfNoTarget", "cues.toml", "gaze = \"seat 12\"", "gaze = \"seat 21\"",
     "cues.toml:[0-9]+: cue 4.gaze: there is no gaze target \"seat 21\"; did you mean \"seat 12\"[?]"},
    {"CueOfNoPartOfLife", "cues.toml", "life = { glance = 0.3 }", "life = { glanse = 0.3 }",
     "cues.toml:[0-9]+: cue 4.life.glanse: is not known here; did you mean \"glance\"[?]"},
};

const Mistake kInTheCast[] = {
    {"FaceWithoutAFile", "faces/cast.toml", "\"poster\"", "\"postre\"",
     "cast.toml:[0-9]+: faces: \"postre\": read .*faces/postre.toml: No such file"},
    {"FaceThatIsNotNamed", "faces/new.toml", "", "shape = \"carved\"\nlike = \"kaori\"\n",
     "cast.toml:[0-9]+: faces: does not name \"new\", though .*faces/new.toml is there"},
    {"LookThatIsNotNamed", "looks/new.toml", "", "[skin]\n",
     "cast.toml:[0-9]+: faces: does not name \"new\", though .*looks/new.toml is there"},
    {"FaceNamedTwice", "faces/cast.toml", "\"round\"", "\"kaori\"",
     "cast.toml:[0-9]+: faces: \"kaori\" is given twice"},
    {"EyeInMetres", "faces/round.toml", "radius = 2.35", "radius = 0.0235",
     "round.toml:[0-9]+: eye.radius: is 0.0235, and must lie between 0.3 and 10: lengths are centimetres"},
    {"EyeInMillimetres", "faces/kaori.toml", "radius = 2.2", "radius = 22",
     "kaori.toml:[0-9]+: eye.radius: is 22, and must lie between 0.3 and 10: lengths are centimetres"},
    {"MouthInMetres", "faces/narrator.toml", "half_width = 2.5", "half_width = 0.025",
     "narrator.toml:[0-9]+: mouth.half_width: is 0.025, and must lie between"},
    {"BodyInMetres", "faces/kaori.toml", "",
     "[[body]]\nellipsoid = \"add\"\ncentre = [0, 0, 0]\nradii = [0.08, 0.085, 0.089]\n",
     "kaori.toml:[0-9]+: body.*radii: the largest is 0.089, and must lie between .*centimetres"},
    {"WordInAFace", "faces/kaori.toml", "upturn", "upturm",
     "kaori.toml:[0-9]+: mouth.upturm: is not known here; did you mean \"upturn\"[?]"},
    {"FaceLikeNobody", "faces/poster.toml", "like = \"kaori\"", "like = \"kaorl\"",
     "poster.toml:[0-9]+: like: must name .*there is no face \"kaorl\"; did you mean \"kaori\"[?]"},
    {"ShapeThatIsNone", "faces/poster.toml", "shape = \"carved\"", "shape = \"craved\"",
     "poster.toml:[0-9]+: shape: must be \"carved\", .*did you mean \"carved\"[?]"},
    {"VertexThatIsNone", "faces/dog.toml", "at = \"grid 0 8\"", "at = \"grid 0 13\"",
     "dog.toml:[0-9]+: landmark.1..at: names no vertex"},
    {"BrokenToml", "faces/kaori.toml", "radius = 2.2", "radius = = 2.2", "kaori.toml:[0-9]+: "},
};

const Mistake kInALook[] = {
    {"LookInMetres", "looks/kaori.toml", "iris_radius = 1.32", "iris_radius = 0.0132",
     "kaori.toml:[0-9]+: eyes.iris_radius: is 0.0132, and must lie between 0.1 and 8: lengths are "
     "centimetres"},
    {"ColourByItsName", "looks/kaori.toml", "iris = \"", "iris = \"blue",
     "kaori.toml:[0-9]+: eyes.iris: must be a colour such as"},
    {"HideThatIsNone", "looks/dog.toml", "hide = \"coat\"", "hide = \"coats\"",
     "dog.toml:[0-9]+: skin.hide: must be one of .*did you mean \"coat\"[?]"},
    {"TableOfALook", "looks/round.toml", "[lips]", "[lipz]",
     "round.toml:[0-9]+: lipz: is not known here; did you mean \"lips\"[?]"},
    {"ShoulderInMillimetres", "looks/kaori.toml", "shoulders = ", "shoulders = 10",
     "kaori.toml:[0-9]+: clothes.shoulders: must lie between 5 and 25"},
};

const Mistake kInTheExpressions[] = {
    {"PointThatIsNone", "expressions.toml", "",
     "[[expression]]\nname = \"new\"\nboth = { MCC = [1, 0, 0] }\n",
     "expressions.toml:[0-9]+: expression.*both.MCC: is no control point; did you mean \"MC\"[?]"},
    {"ExpressionOfANameThatIsTaken", "expressions.toml", "name = \"angry\"", "name = \"smile\"",
     "expressions.toml:[0-9]+: expression.*name: another expression has it already: \"smile\""},
    {"MovesInMillimetres", "expressions.toml", "",
     "[[expression]]\nname = \"new\"\nboth = { MC = [3.5, 14, 0.5] }\n",
     "expressions.toml:[0-9]+: expression.*both.MC: moves by 14, and 5 is the most: lengths are centimetres"},
    {"MovesInMetres", "expressions.toml", "",
     "[[expression]]\nname = \"new\"\nboth = { MC = [0.0035, 0.004, 0] }\n",
     "expressions.toml:[0-9]+: expression.*: moves no point by more than 0.004 cm, .*centimetres"},
    {"LidsInPercent", "expressions.toml", "lids = [1, 0]", "lids = [100, 0]",
     "expressions.toml:[0-9]+: expression.*lids: must be two numbers from 0"},
    {"KindThatIsNone", "expressions.toml", "kind = \"channel\"", "kind = \"chanel\"",
     "expressions.toml:[0-9]+: expression.*kind: must be .*did you mean \"channel\"[?]"},
    {"FromAnExpressionThatIsNone", "expressions.toml", "from = { smile = 1.1,", "from = { smiel = 1.1,",
     "expressions.toml:[0-9]+: .*from.smiel: is no expression written before this one; did you mean "
     "\"smile\"[?]"},
    {"PointGivenTwice", "expressions.toml", "F1 = [0, 4.6]", "F1 = [0, 4.6]\nF1 = [0, 4.7]",
     "expressions.toml:[0-9]+: .*F1"},
    {"PointOffTheLeftHalf", "expressions.toml", "B1 = [1.45, 2]", "B1 = [-1.45, 2]",
     "expressions.toml:[0-9]+: point.B1: must be a position .* on the left half of the face"},
};

class AMistake : public CheckedFolder, public ::testing::WithParamInterface<Mistake> {};

TEST_P(AMistake, IsRefusedWithFileLineAndReason) {
  const Mistake& mistake = GetParam();
  if (*mistake.what == '\0')
    Append(mistake.file, mistake.with);
  else
    Replace(mistake.file, mistake.what, mistake.with);
  const auto faults = CheckFolder(show_).faults;
  EXPECT_THAT(faults, Contains(ContainsRegex(mistake.says)));
  CountNamed(::testing::Value(faults, Contains(ContainsRegex(mistake.says))));
}

std::string NameOf(const ::testing::TestParamInfo<Mistake>& mistake) {
  return mistake.param.name;
}

INSTANTIATE_TEST_SUITE_P(InTheScript, AMistake, ::testing::ValuesIn(kInTheScript), NameOf);
INSTANTIATE_TEST_SUITE_P(InTheGaze, AMistake, ::testing::ValuesIn(kInTheGaze), NameOf);
INSTANTIATE_TEST_SUITE_P(InTheCues, AMistake, ::testing::ValuesIn(kInTheCues), NameOf);
INSTANTIATE_TEST_SUITE_P(InTheCast, AMistake, ::testing::ValuesIn(kInTheCast), NameOf);
INSTANTIATE_TEST_SUITE_P(InALook, AMistake, ::testing::ValuesIn(kInALook), NameOf);
INSTANTIATE_TEST_SUITE_P(InTheExpressions, AMistake, ::testing::ValuesIn(kInTheExpressions), NameOf);

class AMissingFile : public CheckedFolder, public ::testing::WithParamInterface<const char*> {};

TEST_P(AMissingFile, IsNamed) {
  std::filesystem::remove(show_ / GetParam());
  EXPECT_THAT(CheckFolder(show_).faults, Contains(ContainsRegex(std::string(GetParam()) + ": No such file")));
}

INSTANTIATE_TEST_SUITE_P(OfAShow, AMissingFile,
                         ::testing::Values("show.toml", "expressions.toml", "faces/cast.toml",
                                           "faces/dog.toml", "looks/dog.toml"));

TEST_F(CheckedFolder, RefusesTablesThatNestDeeperThanAParserCanFollow) {
  std::string deep = "[a";
  for (int n = 0; n < 200'000; ++n) deep += ".a";
  Append("show.toml", deep + "]\n");
  EXPECT_THAT(CheckFolder(show_).faults, Contains(ContainsRegex("show.toml:[0-9]+: is nested deeper than")));
}

TEST_F(CheckedFolder, TakesASceneOfACueWithoutATimeAsOneThatFadesAsItSaysItself) {
  Replace("cues.toml", "panic = { name = \"studio\", in_s = 1.0 }", "panic = { name = \"studio\" }");
  EXPECT_THAT(CheckFolder(show_).faults, ::testing::IsEmpty());
}

TEST_F(CheckedFolder, NamesAnExpressionThatFoldsTheSkin) {
  Append("expressions.toml", "[[expression]]\nname = \"pinched\"\nboth = { MC = [-1.6, 0, 0] }\n");
  const auto check = CheckFolder(show_);
  EXPECT_THAT(check.faults, ::testing::IsEmpty()) << "it can be packed";
  EXPECT_THAT(check.flaws,
              ::testing::ElementsAre(ContainsRegex(
                  "expressions.toml:[0-9]+: expression \"pinched\": folds the skin of .*kaori.*triangles")));
}

// The lines of the guide that begin with [[expression]], as one types them off.
std::string ExpressionOfTheGuide() {
  std::ifstream guide(KAORI_GUIDE "/expression.md");
  std::string text;
  for (std::string line; std::getline(guide, line);) {
    if (text.empty() && line != "    [[expression]]") continue;
    if (!line.starts_with("    ")) break;
    text += line.substr(4) + "\n";
  }
  return text;
}

TEST_F(CheckedFolder, FindsNothingWrongWithTheExpressionOfTheGuide) {
  ASSERT_THAT(ExpressionOfTheGuide(), ContainsRegex("name = \"half_smile\""));
  Append("expressions.toml", "\n" + ExpressionOfTheGuide());
  const auto check = CheckFolder(show_);
  EXPECT_THAT(check.faults, ::testing::IsEmpty());
  EXPECT_THAT(check.flaws, ::testing::IsEmpty());
}

}  // namespace
}  // namespace kaori::tests
