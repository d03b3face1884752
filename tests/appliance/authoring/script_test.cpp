// The script of a show: what is written wrongly is named with its file, item and line, and nothing is
// guessed.
#include "appliance/authoring/script/show_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <ostream>

#include "appliance/authoring/script/taken_keys.h"
#include "appliance/programs/editor/keys.h"
#include "render/image/png.h"

namespace kaori::authoring {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kScene = R"(
[[scene]]
name = "studio"
key = "f1"
face = "kaori"
fade_s = 1
backdrop = { top = "#ffffff", bottom = "#000000" }
)";

class ScriptTest : public ::testing::Test {
 protected:
  ~ScriptTest() override { std::remove(file_.c_str()); }

  std::vector<std::string> Read(const std::string& text) {
    std::ofstream(file_) << text;
    show_ = {};
    show_.cast.faces.resize(2);
    show_.cast.faces[1].name = "kaori";
    show_.cast.expressions.resize(2);
    show_.cast.expressions[0].name = "neutral";
    show_.cast.expressions[1].name = "jaw_open";
    return ReadShowFile(file_, show_);
  }

  std::string file_ = ::testing::TempDir() + "kaori-script-" + std::to_string(::getpid()) + ".toml";
  show::Show show_;
};

TEST_F(ScriptTest, IsReadIntoScenesAndMotions) {
  const auto faults = Read(std::string(kScene) +
                           "[[motion]]\nname = \"nod\"\nkey = \"2\"\nhead_pitch = [[0, 0], [1, 90], [2, 0]]\n"
                           "jaw_open = [[0, 0], [1, 0.5], [2, 0]]\n");
  EXPECT_THAT(faults, IsEmpty());
  ASSERT_EQ(show_.scenes.size(), 1U);
  EXPECT_EQ(show_.scenes[0].face, 1);
  EXPECT_EQ(show_.scenes[0].key_usage, 0x3A);
  EXPECT_FLOAT_EQ(show_.scenes[0].fade_s, 1);
  EXPECT_FLOAT_EQ(show_.scenes[0].backdrop.top.x, 1);
  ASSERT_EQ(show_.motions.size(), 1U);
  EXPECT_EQ(show_.motions[0].key_usage, 0x1F);
  ASSERT_EQ(show_.motions[0].curves.size(), 2U);
  EXPECT_NEAR(show_.motions[0].curves[0].keys[1].value, 1.5708F, 1e-3F) << "degrees become radians";
  EXPECT_EQ(show_.motions[0].curves[1].channel, 1);
}

TEST_F(ScriptTest, GivesKeysWhatButtonsMayCall) {
  EXPECT_THAT(Read(std::string("[keys]\nq = \"style wire\"\nf9 = \"face kaori\"\n") + kScene), IsEmpty());
  ASSERT_EQ(show_.keys.size(), 2U);
  const bool face_first = show_.keys[0].call.kind == show::CallKind::kFace;
  const show::KeyCall& face = show_.keys[face_first ? 0 : 1];
  const show::KeyCall& style = show_.keys[face_first ? 1 : 0];
  EXPECT_EQ(style.key_usage, 0x14);
  EXPECT_EQ(style.call.kind, show::CallKind::kStyle);
  EXPECT_EQ(style.call.index, static_cast<int>(scene::Style::kWire));
  EXPECT_EQ(face.key_usage, 0x42);
  EXPECT_EQ(face.call.index, 1);
}

TEST_F(ScriptTest, NamesWhatStandsBehindAScene) {
  const auto faults = Read(
      "[[scene]]\nface = \"kaori\"\n"
      "backdrop = { kind = \"curtain\", top = \"#ff0000\", bottom = \"#000000\", glow = \"#ffffff\" }\n");
  EXPECT_THAT(faults, IsEmpty());
  const scene::Backdrop& backdrop = show_.scenes.at(0).backdrop;
  EXPECT_EQ(backdrop.kind, scene::BackdropKind::kCurtain);
  EXPECT_FLOAT_EQ(backdrop.top.x, 1);
  EXPECT_FLOAT_EQ(backdrop.glow.z, 1);
}

TEST_F(ScriptTest, PutsAPictureFromBesideItIntoTheShow) {
  const std::filesystem::path file =
      ::testing::TempDir() + "kaori-backdrop-" + std::to_string(::getpid()) + ".png";
  image::Picture picture = image::Picture::Blank(2, 3);
  picture.rgbx[0] = 200;  // The bottom row's first pixel.
  ASSERT_TRUE(image::WritePng(file, picture));
  const auto faults =
      Read("[[scene]]\nface = \"kaori\"\nbackdrop = { picture = \"" + file.filename().string() + "\" }\n");
  std::filesystem::remove(file);
  EXPECT_THAT(faults, IsEmpty());
  const scene::Backdrop& backdrop = show_.scenes.at(0).backdrop;
  EXPECT_EQ(backdrop.kind, scene::BackdropKind::kPicture);
  ASSERT_EQ(backdrop.picture, 0);
  const face::Texture& texture = show_.cast.textures.at(0);
  EXPECT_EQ(texture.height_px, 3);
  EXPECT_EQ(texture.rgba[2 * 2 * 4], 200) << "the top row comes first";
}

struct Wrong {
  const char* name;
  const char* text;  // After the scene.
  const char* line;
  friend void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }
};
const Wrong kWrongs[] = {
    {"AWordThatIsNone", "expresion = \"neutral\"",
     ":8: scene \"studio\".expresion: is not known here; did you mean \"expression\"?"},
    {"ATableThatIsNone", "[[scenes]]", ":8: scenes: is not known here; did you mean \"scene\"?"},
    {"AnExpressionThatIsNone", "expression = \"smlie\"",
     ":8: scene \"studio\".expression: there is no expression \"smlie\""},
    {"ANumberInQuotes", "light = \"1\"", ":8: scene \"studio\".light: must be a number"},
    {"ATextWithoutQuotes", "style = 3", ":8: scene \"studio\".style: must be a text in quotes"},
    {"AStyleThatIsNone", "style = \"Wire\"",
     ":8: scene \"studio\".style: there is no style \"Wire\"; styles are wire"},
    {"AColourThatIsNone",
     "[[scene]]\nface = \"kaori\"\nbackdrop = { top = \"#12345g\", bottom = \"#000000\" }",
     ":10: scene[2].backdrop.top: \"#12345g\" is no colour"},
    {"ABackdropOfNoKind",
     "[[scene]]\nname = \"b\"\nface = \"kaori\"\nbackdrop = { kind = \"curtian\", top = \"#000000\", bottom "
     "= "
     "\"#000000\" }",
     ":11: scene \"b\".backdrop.kind: there is no kind \"curtian\"; kinds are gradient, studio, curtain"},
    {"ABackdropWithAWordThatIsNone",
     "[[scene]]\nface = \"kaori\"\nbackdrop = { topp = \"#000000\", top = \"#000000\", bottom = \"#000000\" "
     "}",
     ":10: scene[2].backdrop.topp: is not known here; did you mean \"top\"?"},
    {"ABackdropThatIsNoTable", "[[scene]]\nface = \"kaori\"\nbackdrop = 3",
     ":10: scene[2].backdrop: must be a table"},
    {"APictureThatIsNotThere", "[[scene]]\nface = \"kaori\"\nbackdrop = { picture = \"none.png\" }",
     ":10: scene[2].backdrop.picture: "},
    {"AKeyThatIsNone", "[[motion]]\nkey = \"f13\"\nlids = [[0, 0], [1, 0]]",
     ":9: motion[1].key: there is no key \"f13\""},
    {"APairOfThree", "[[motion]]\nlids = [[0, 0, 0], [1, 0]]",
     ":9: motion \"unnamed\".lids: a pair [second, value] is expected"},
    {"ACurveThatIsANumber", "[[motion]]\nlids = 3", ":9: motion[1].lids: must be a list of pairs"},
    {"ACurveOfNothing", "[[motion]]\nears = [[0, 0], [1, 0]]",
     ":9: motion[1].ears: there is no target or channel \"ears\""},
    {"AMotionOfNothing", "[[motion]]\nname = \"nod\"", ":8: motion \"nod\": it moves nothing"},
    {"ChannelsOfNoRole", "[channels]\nbrow = \"jaw_open\"", ":9: channels.brow: is not known here"},
    {"ACallOnAKeyThatIsNone", "[keys]\nf13 = \"style wire\"", ":9: keys.f13: there is no key \"f13\""},
    {"AKeyThatCallsNothingThatIs", "[keys]\nq = \"light on\"",
     ":9: keys.q: \"light\" is none of face, expression, style, scene"},
    {"ACallWithoutQuotes", "[keys]\nq = 7", ":9: keys.q: must be a text in quotes"},
    {"KeysThatAreNoTable", "[[keys]]\nq = \"style wire\"", ":8: keys: must be a table"},
    {"AKeyThatIsGivenTwice", "[keys]\nf1 = \"style wire\"",
     ":9: keys.f1: the key \"f1\" is given twice: it is that of scene \"studio\" in line 4"},
    {"ASceneOfANameThatIsTaken",
     "[[scene]]\nname = \"studio\"\nface = \"kaori\"\nbackdrop = { top = \"#000000\", bottom = \"#000000\" }",
     ":9: scene \"studio\".name: the name \"studio\" is given twice"},
    {"AMotionByItsFormerName", "[[take]]\nname = \"nod\"\nlids = [[0, 0], [1, 0]]",
     ":8: take: a registered motion is now written [[motion]], not [[take]]"},
    {"AKeyThatTheBoxUses", "[keys]\nz = \"style wire\"",
     ":9: keys.z: the key \"z\" belongs to the box: it winks"},
    {"AKeyOfTheExpressionEditor", "[keys]\nm = \"style wire\"",
     ":9: keys.m: the key \"m\" belongs to the box"},
    {"AKeyOfTheCalibration", "[keys]\nf12 = \"style wire\"", "it begins the calibration of the lips"},
    {"ATurnTooFar", "[[motion]]\nname = \"nod\"\nhead_yaw = [[0, 0], [1, 1200], [2, 0]]",
     ":10: motion \"nod\".head_yaw: 1200 degrees, and 229 to either side are the most"},
    {"AFadeInMilliseconds", "[[scene]]\nname = \"b\"\nface = \"kaori\"\nfade_s = 800",
     ":11: scene \"b\".fade_s: is 800 s, not within 0 to 60"},
    {"ATimeThatRunsBack", "[[motion]]\nname = \"nod\"\nlids = [[0, 0], [1, 1],\n[0.5, 0.5], [2, 0]]",
     ":11: motion \"nod\".lids: second 0.5 must lie after second 1"},
    {"AMotionThatWouldJump", "[[motion]]\nname = \"nod\"\nlids = [[0, 0],\n[1, 1]]",
     ":11: motion \"nod\".lids: a curve must start and end at 0"},
    {"ASceneWithoutAFace", "[[scene]]\nname = \"b\"\nbackdrop = { top = \"#000000\", bottom = \"#000000\" }",
     ":8: scene \"b\".face: is missing"},
    {"ASceneWithoutABackdrop", "[[scene]]\nname = \"b\"\nface = \"kaori\"",
     ":8: scene \"b\".backdrop: is missing"},
    {"AMotionOfANameThatIsTaken",
     "[[motion]]\nname = \"nod\"\nlids = [[0, 0], [1, 0]]\n[[motion]]\nname = \"nod\"\nlids = [[0, 0], [1, "
     "0]]",
     ":12: motion \"nod\".name: the name \"nod\" is given twice"},
    {"ATypingError", "light = = 1", ":8:"},
};

class AWrongScript : public ScriptTest, public ::testing::WithParamInterface<Wrong> {};

TEST_P(AWrongScript, IsNamed) {
  EXPECT_THAT(Read(std::string(kScene) + GetParam().text + "\n"),
              Contains(::testing::AllOf(HasSubstr(file_), HasSubstr(GetParam().line))));
}

INSTANTIATE_TEST_SUITE_P(Each, AWrongScript, ::testing::ValuesIn(kWrongs),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

TEST_F(ScriptTest, WithoutAnySceneIsNamed) {
  EXPECT_THAT(Read("name = \"empty\"\n"), Contains(HasSubstr("scene: there is none")));
}

TEST_F(ScriptTest, WithButtonsThatAreNoRowsOfTextsIsNamed) {
  EXPECT_THAT(Read(std::string("buttons = 3\n") + kScene),
              Contains(HasSubstr(":1: buttons: must be a list of rows")));
  EXPECT_THAT(Read(std::string("buttons = [\"face kaori\"]\n") + kScene),
              Contains(HasSubstr(":1: buttons: a row [...] of texts is expected")));
  EXPECT_THAT(Read(std::string("buttons = [[\"\", 7]]\n") + kScene),
              Contains(HasSubstr(":1: button 2: must be a text in quotes")));
}

TEST_F(ScriptTest, WithAnotherNumberOfButtonsThanTheBoxIsNamed) {
  EXPECT_THAT(Read(std::string("buttons = [[\"face kaori\", \"\"]]\n") + kScene),
              Contains(HasSubstr(":1: buttons: 2 are given; the box has 32")));
}

TEST(TakenKeys, HoldEveryLetterOfTheExpressionEditor) {
  for (std::uint16_t usage = 0x04; usage <= 0x1D; ++usage) {  // HID usages of a to z.
    if (editor::IsForEditor(static_cast<std::uint8_t>(usage))) {
      EXPECT_NE(UseOfTheBox(usage), "") << usage;
    }
  }
}

}  // namespace
}  // namespace kaori::authoring
