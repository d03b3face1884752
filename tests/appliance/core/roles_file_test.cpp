// roles.toml: what it may say, and each of its mistakes with file, line and reason.
#include "appliance/core/roles/roles_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

namespace kaori::roles {
namespace {

using show::Control;
using show::Level;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RolesFileTest : public ::testing::Test {
 protected:
  RolesFileTest() { std::filesystem::create_directories(folder_); }
  ~RolesFileTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path Write(const std::string& text) {
    std::filesystem::path file = folder_ / "roles.toml";
    std::ofstream(file) << text;
    return file;
  }
  std::vector<std::string> Read(const std::string& text) {
    return ReadRolesFile(Write(text), items_, roles_);
  }
  // A file with one map in one role of the left stick.
  std::vector<std::string> ReadMap(const std::string& map) {
    return Read("[[role]]\nname = \"head\"\ndevice = \"left stick\"\n[[role.map]]\n" + map);
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("kaori-roles-" + std::to_string(::getpid()));
  Items items_{.faces = {"kaori", "dog"}, .expressions = {"neutral", "angry", "laugh"}};
  show::Roles roles_;
  Besides besides_;
};

TEST_F(RolesFileTest, SaysDeviceControlsLevelsRangesCurvesAndTakeOvers) {
  EXPECT_THAT(Read(R"(handover_s = 0.5
[[role]]
name = "head"
device = "right stick"
[[role.map]]
control = "slider"
level = "head_lean"
range = [6, 0]
takeover = "pickup"
[[role.map]]
control = "x"
level = "head_yaw"
range = [-10, 20]
dead = 0.04
curve = 1.6
[[role]]
name = "levels"
device = "dial box"
[[role.map]]
control = "dial 3"
level = "strength"
per_turn = 0.7
)"),
              IsEmpty());
  EXPECT_FLOAT_EQ(roles_.handover_s, 0.5F);
  ASSERT_EQ(roles_.roles.size(), 2U);
  const show::Role& head = roles_.roles[0];
  EXPECT_EQ(head.device, show::Device::kRightStick);
  ASSERT_EQ(head.maps.size(), 2U);
  EXPECT_EQ(head.maps[0].level, Level::kHeadYaw) << "in the order of the levels";
  EXPECT_FLOAT_EQ(head.maps[0].to, 20 * show::kDegree);
  EXPECT_FLOAT_EQ(head.maps[0].exponent, 1.6F);
  EXPECT_FLOAT_EQ(head.maps[1].from, 0.06F) << "swapped ends invert";
  EXPECT_FLOAT_EQ(head.maps[1].to, 0);
  EXPECT_EQ(head.maps[1].takeover, show::Takeover::kPickUp);
  EXPECT_FLOAT_EQ(roles_.roles[1].maps[0].to, 0.7F);
  EXPECT_EQ(roles_.roles[1].maps[0].dial, 2);
}

TEST_F(RolesFileTest, TellsAllOfItsMistakesAtOnceEachWithItsLine) {
  const auto faults = Read(R"(handover_s = 99
[[role]]
name = "head"
device = "third stick"
[[role.map]]
control = "wheel"
level = "head_yaw"
[[role]]
name = "gaze"
device = "right stick"
[[role.map]]
control = "x"
level = "gaze_jaw"
[[role.map]]
control = "y"
level = "gaze_pitch"
range = [-90, 10]
[[role.map]]
control = "twist"
level = "brow"
dead = 2
colour = "red"
)");
  EXPECT_THAT(faults,
              ElementsAre(HasSubstr("roles.toml:1: handover_s: is 99 s"),
                          AllOf(HasSubstr(":4: role \"head\".device"), HasSubstr("left stick, right stick")),
                          AllOf(HasSubstr(":6: role \"head\".map[1].control"), HasSubstr("\"wheel\"")),
                          AllOf(HasSubstr(":13: "), HasSubstr("\"gaze_jaw\" is none of face")),
                          AllOf(HasSubstr(":17: "), HasSubstr("-90 is not within"), HasSubstr("degrees")),
                          AllOf(HasSubstr(":22: "), HasSubstr("colour")),
                          AllOf(HasSubstr(":21: "), HasSubstr("is 2, not within 0 to 0.9"))));
}

TEST_F(RolesFileTest, NamesEveryFaultyFile) {
  const std::pair<const char*, const char*> kFaulty[] = {
      {"control = \"dial 1\"\nlevel = \"life\"", "the left stick has no dial 1"},
      {"control = \"x\"\nlevel = \"life\"\nper_turn = 1", "is for dials"},
      {"control = \"x\"\nlevel = \"life\"\nrange = [1, 1]", "two different numbers"},
      {"control = \"x\"\nlevel = \"life\"\nrange = [0, 0.5, 1]", "two different numbers"},
      {"control = \"x\"\nlevel = \"life\"\ncurve = 0", "not within 0.1 to 10"},
      {"control = \"x\"\nlevel = \"life\"\ncurve = [[0, 0], [1, 0.5]]", "rise from [0, 0] to [1, 1]"},
      {"control = \"x\"\nlevel = \"life\"\ncurve = [[0, 0], [0.6, 0.1], [0.5, 0.2], [1, 1]]", "rise from"},
      {"control = \"x\"\nlevel = \"life\"\ncurve = [1, 2]", "must be two numbers"},
      {"control = \"x\"\nlevel = \"life\"\ncurve = \"steep\"", "must be an exponent"},
      {"control = \"x\"\nlevel = \"life\"\ntakeover = \"pickup\"", "stay where they are put"},
      {"control = \"slider\"\nlevel = \"life\"\ntakeover = \"soon\"", "is none of jump, pickup, scale"},
      {"control = \"x\"", "level: is missing"},
      {"level = \"life\"", "control: is missing"},
      {"control = 3\nlevel = \"life\"", "must be a text"},
      {"control = \"x\"\nlevel = \"life\"\ndead = \"much\"", "must be a number"},
  };
  for (const auto& [map, reason] : kFaulty)
    EXPECT_THAT(ReadMap(map), ElementsAre(AllOf(HasSubstr("roles.toml:"), HasSubstr(reason)))) << map;
  EXPECT_THAT(Read(""), ElementsAre(HasSubstr("there is none")));
  EXPECT_THAT(Read("[[role]\n"), ElementsAre(HasSubstr("roles.toml:1")));
  EXPECT_THAT(
      Read("[[role]]\nname = \"a\"\ndevice = \"dial box\"\n[[role]]\nname = \"a\"\ndevice = \"dial box\"\n"),
      ElementsAre(HasSubstr("given twice")));
  std::string many;
  for (int i = 0; i < 9; ++i) many += fmt::format("[[role]]\nname = \"r{}\"\ndevice = \"dial box\"\n", i);
  EXPECT_THAT(Read(many), ElementsAre(HasSubstr("there are 9, and 8 is the most")));
}

TEST_F(RolesFileTest, ComesBackFromItsText) {
  roles_ = show::UsualRoles();
  roles_.roles[1].maps[0].points = {{0, 0}, {0.3F, 0.1F}, {1, 1}};
  roles_.roles[1].maps[3].takeover = show::Takeover::kScale;
  roles_.roles[2].maps[0].dead = 0.07F;
  const std::string text = TextOf(roles_, items_);
  ASSERT_THAT(Read(text), IsEmpty()) << text;
  EXPECT_EQ(TextOf(roles_, items_), text);
  EXPECT_EQ(roles_.roles[1].maps[0].to, show::UsualRoles().roles[1].maps[0].to) << "to the bit";
}

TEST_F(RolesFileTest, OfTheBoxLiesOverThatOfTheShow) {
  roles_ = show::UsualRoles();
  const auto faults = LayOver(Write(R"([[role]]
name = "head"
[[role.map]]
control = "slider"
level = "head_yaw"
[[role]]
name = "lids"
device = "right stick"
[[role.map]]
control = "twist"
level = "lid_left"
)"),
                              items_, roles_, besides_);
  ASSERT_THAT(faults, IsEmpty());
  const show::Role& head = roles_.roles[1];
  EXPECT_EQ(head.device, show::Device::kLeftStick) << "as the show has it";
  ASSERT_EQ(head.maps.size(), 4U);
  EXPECT_EQ(head.maps[0].control, Control::kSlider) << "instead of the show's map of that level";
  EXPECT_EQ(head.maps[1].level, Level::kHeadPitch) << "the others stay";
  ASSERT_EQ(roles_.roles.size(), 4U);
  EXPECT_EQ(roles_.roles[3].name, "lids");
}

TEST_F(RolesFileTest, OfTheBoxThatIsWrongChangesNothing) {
  roles_ = show::UsualRoles();
  const std::string before = TextOf(roles_, items_);
  const auto faults =
      LayOver(Write("[[role]]\nname = \"head\"\n[[role.map]]\ncontrol = \"dial 1\"\nlevel = \"head_yaw\"\n"),
              items_, roles_, besides_);
  EXPECT_THAT(faults,
              ElementsAre(AllOf(HasSubstr("roles.toml"), HasSubstr("its device has no such control"))));
  EXPECT_EQ(TextOf(roles_, items_), before);
}

TEST_F(RolesFileTest, OfTheBoxNamesNoRoleWithoutADeviceThatTheShowHasNot) {
  roles_ = show::UsualRoles();
  const std::string before = TextOf(roles_, items_);
  const char* const map = "[[role.map]]\ncontrol = \"slider\"\nlevel = \"head_yaw\"\n";
  const auto faults =
      LayOver(Write(std::string("\n[[role]]\nname = \"haed\"\n") + map), items_, roles_, besides_);
  EXPECT_THAT(faults, ElementsAre(AllOf(HasSubstr("roles.toml:3: role \"haed\""),
                                        HasSubstr("no role \"haed\""), HasSubstr("did you mean \"head\""))));
  EXPECT_THAT(besides_.warnings, IsEmpty());
  EXPECT_EQ(TextOf(roles_, items_), before);
  EXPECT_THAT(LayOver(Write(std::string("[[role]]\nname = \"haed\"\ndevice = \"left stick\"\n") + map),
                      items_, roles_, besides_),
              IsEmpty())
      << "with a device it is a role of its own";
  EXPECT_EQ(roles_.roles.back().name, "haed");
  EXPECT_THAT(besides_.warnings,
              ElementsAre(AllOf(HasSubstr("roles.toml:2: role \"haed\""), HasSubstr("did you mean"))));
}

TEST_F(RolesFileTest, OfTheBoxTakesALevelFromARole) {
  roles_ = show::UsualRoles();
  const char* const text =
      "[[role]]\nname = \"head\"\n[[role.map]]\ncontrol = \"none\"\nlevel = \"head_yaw\"\n";
  ASSERT_THAT(LayOver(Write(text), items_, roles_, besides_), IsEmpty());
  ASSERT_EQ(roles_.roles[1].maps.size(), 3U);
  EXPECT_EQ(roles_.roles[1].maps[0].level, Level::kHeadPitch);
  EXPECT_THAT(Read(std::string("[[role]]\nname = \"head\"\ndevice = \"left stick\"\n[[role.map]]\n") +
                   "control = \"none\"\nlevel = \"head_yaw\"\n"),
              ElementsAre(HasSubstr("there is no control \"none\"")))
      << "a show takes nothing from itself";
}

TEST_F(RolesFileTest, ComesBackWithAnyName) {
  roles_ = show::UsualRoles();
  items_.expressions[1] = "\"angry\" \\ 怒り";
  roles_.roles[1].name = "die \"Köpfe\" \\ 頭\n";
  roles_.mixes = {{show::CallKind::kExpression, 1}};
  roles_.roles[0].maps.push_back({.control = Control::kDial, .dial = 1, .level = Level::kMix1, .to = 1});
  const std::string text = TextOf(roles_, items_);
  ASSERT_THAT(Read(text), IsEmpty()) << text;
  EXPECT_EQ(roles_.roles[1].name, "die \"Köpfe\" \\ 頭\n");
  EXPECT_EQ(TextOf(roles_, items_), text);
}

TEST_F(RolesFileTest, PlaysFacesAndExpressionsOfTheShowByTheirNames) {
  EXPECT_THAT(Read(R"([[role]]
name = "mixer"
device = "dial box"
[[role.map]]
control = "dial 1"
level = "expression angry"
[[role.map]]
control = "dial 2"
level = "face dog"
[[role.map]]
control = "dial 3"
level = "expression angry"
)"),
              IsEmpty());
  ASSERT_EQ(roles_.mixes.size(), 2U) << "one level for each, however many maps it has";
  EXPECT_EQ(roles_.mixes[0].kind, show::CallKind::kExpression);
  EXPECT_EQ(roles_.mixes[0].index, 1);
  EXPECT_EQ(roles_.mixes[1].kind, show::CallKind::kFace);
  EXPECT_EQ(roles_.roles[0].maps[2].level, show::MixLevel(1)) << "maps of one level stand together";
  const std::string text = TextOf(roles_, items_);
  ASSERT_THAT(Read(text), IsEmpty()) << text;
  EXPECT_EQ(TextOf(roles_, items_), text);
  EXPECT_THAT(ReadMap("control = \"slider\"\nlevel = \"expression angyr\"\n"),
              ElementsAre(AllOf(HasSubstr("roles.toml:6"), HasSubstr("there is no expression \"angyr\""),
                                HasSubstr("did you mean \"angry\""))));
}

}  // namespace
}  // namespace kaori::roles
