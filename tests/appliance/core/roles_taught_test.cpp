// What was taught, as lines of the box's own roles.toml.
#include "appliance/core/roles/taught.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/roles/roles_file.h"

namespace kaori::roles {
namespace {

using show::Control;
using show::Device;
using show::Level;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class TaughtTest : public ::testing::Test {
 protected:
  // The whole of the level, by a control of this device.
  Taught By(Device device, const char* control, const char* name, Level level) const {
    const auto named = show::ControlNamed(control).value();
    const show::LevelInfo& info = show::InfoOf(level);
    const bool turns = show::Turns(named.control);
    return {.level = name,
            .device = device,
            .map = {.control = named.control,
                    .dial = named.dial,
                    .level = level,
                    .from = turns ? 0 : info.low,
                    .to = turns ? info.high - info.low : info.high}};
  }
  // Teaches on, and gives the roles as they are played then.
  show::Roles Learn(const Taught& taught) {
    const auto text = Teach(text_, "roles.toml", items_, below_, taught);
    EXPECT_TRUE(text) << text.error().message();
    text_ = text.value_or("");
    show::Roles laid = below_;
    EXPECT_THAT(LayOverText(text_, "roles.toml", items_, laid, besides_), IsEmpty()) << text_;
    return laid;
  }
  void LearnButton(std::uint8_t button, const char* call) {
    const auto text = Teach(text_, "roles.toml", items_, below_, TaughtButton{button, call});
    ASSERT_TRUE(text) << text.error().message();
    text_ = *text;
    show::Roles laid = below_;
    EXPECT_THAT(LayOverText(text_, "roles.toml", items_, laid, besides_), IsEmpty()) << text_;
  }
  static const show::Role& RoleOf(const show::Roles& roles, std::string_view name) {
    return *std::ranges::find(roles.roles, name, &show::Role::name);
  }
  // Which controls of the role move the level.
  static std::vector<std::string> ControlsOn(const show::Roles& roles, std::string_view role, Level level) {
    std::vector<std::string> names;
    for (const show::RoleMap& map : RoleOf(roles, role).maps)
      if (map.level == level) names.push_back(show::NameOf(map));
    return names;
  }

  Items items_{.faces = {"kaori"}, .expressions = {"neutral", "angry", "the \"old\" \\ 怒り"}};
  show::Roles below_ = show::UsualRoles();
  std::string text_;
  Besides besides_;
};

TEST_F(TaughtTest, BeginsAFileWhereThereIsNone) {
  const show::Roles roles = Learn(By(Device::kLeftStick, "hat x", "head_roll", Level::kHeadRoll));
  EXPECT_THAT(ControlsOn(roles, "head", Level::kHeadRoll), ElementsAre("hat x"))
      << "in the show's role, in place of the twist that played it";
  EXPECT_EQ(roles.roles.size(), below_.roles.size());
  EXPECT_THAT(text_, AllOf(HasSubstr("# The box's own roles"), Not(HasSubstr("device"))));
}

TEST_F(TaughtTest, MakesARoleOfTheDeviceWhereNoneOfItsOwnPlaysTheLevel) {
  Learn(By(Device::kDialBox, "dial 2", "head_yaw", Level::kHeadYaw));
  const show::Roles roles = Learn(By(Device::kDialBox, "dial 3", "brow", Level::kBrow));
  EXPECT_THAT(ControlsOn(roles, "taught dial box", Level::kHeadYaw), ElementsAre("dial 2"));
  EXPECT_THAT(ControlsOn(roles, "taught dial box", Level::kBrow), ElementsAre("dial 3"));
  EXPECT_EQ(RoleOf(roles, "taught dial box").device, Device::kDialBox);
  EXPECT_THAT(ControlsOn(roles, "head", Level::kHeadYaw), ElementsAre("x")) << "another device keeps it";
}

TEST_F(TaughtTest, TakesTheControlFromTheLevelsThatItMovedBefore) {
  const Taught taught = By(Device::kDialBox, "dial 3", "brow", Level::kBrow);
  EXPECT_THAT(OtherLevelsOf(below_, items_, taught), ElementsAre("strength"));
  show::Roles roles = Learn(taught);
  EXPECT_THAT(OtherLevelsOf(roles, items_, taught), IsEmpty());
  for (const show::Role& role : roles.roles)
    for (const show::RoleMap& map : role.maps) EXPECT_NE(map.level, Level::kStrength) << text_;
  roles = Learn(By(Device::kDialBox, "dial 3", "head_yaw", Level::kHeadYaw));
  EXPECT_THAT(ControlsOn(roles, "taught dial box", Level::kBrow), IsEmpty()) << "taught anew";
  EXPECT_THAT(ControlsOn(roles, "taught dial box", Level::kHeadYaw), ElementsAre("dial 3"));
}

TEST_F(TaughtTest, LeavesOtherControlsOfALevelAsTheyAre) {
  below_.roles[1].maps[0].exponent = 1.6F;
  show::RoleMap also = below_.roles[1].maps[0];
  also.control = Control::kTwist;
  below_.roles[1].maps.erase(below_.roles[1].maps.begin() + 2);
  below_.roles[1].maps.insert(below_.roles[1].maps.begin(), also);
  ASSERT_THAT(ControlsOn(below_, "head", Level::kHeadYaw), ElementsAre("twist", "x"));
  const show::Roles roles = Learn(By(Device::kLeftStick, "twist", "brow", Level::kBrow));
  EXPECT_THAT(ControlsOn(roles, "head", Level::kHeadYaw), ElementsAre("x"));
  EXPECT_FLOAT_EQ(RoleOf(roles, "head").maps[0].exponent, 1.6F);
}

TEST_F(TaughtTest, KeepsLinesAndCommentsThatAPersonWrote) {
  text_ = R"(# Our box.
handover_s = 0.5

[[role]]
name = "head"   # as Mari likes it

[[role.map]]
control = "y"   # pulled: up
level = "head_pitch"
range = [10, -10]

[[role.map]]
control = "slider"
level = "head_yaw"

# The lids, for the tall operator.
[[role]]
name = "lids"
device = "right stick"
[[role.map]]
control = "slider"
level = "lid_left"
)";
  const show::Roles roles = Learn(By(Device::kLeftStick, "x", "head_yaw", Level::kHeadYaw));
  EXPECT_EQ(text_, R"(# Our box.
handover_s = 0.5

[[role]]
name = "head"   # as Mari likes it

[[role.map]]
control = "y"   # pulled: up
level = "head_pitch"
range = [10, -10]

[[role.map]]
control = "x"
level = "head_yaw"

# The lids, for the tall operator.
[[role]]
name = "lids"
device = "right stick"
[[role.map]]
control = "slider"
level = "lid_left"
)");
  EXPECT_THAT(ControlsOn(roles, "lids", Level::kLidLeft), ElementsAre("slider"));
  EXPECT_FLOAT_EQ(roles.handover_s, 0.5F);
}

TEST_F(TaughtTest, SaysTheSameAsOftenAsItIsTaught) {
  const Taught taught = By(Device::kDialBox, "dial 3", "head_yaw", Level::kHeadYaw);
  Learn(taught);
  const std::string once = text_;
  Learn(taught);
  EXPECT_EQ(text_, once);
}

TEST_F(TaughtTest, PlaysExpressionsWhateverTheirNames) {
  const std::string name = "expression " + items_.expressions[2];
  const show::Roles roles = Learn(By(Device::kDialBox, "dial 8", name.c_str(), Level::kMix1));
  ASSERT_EQ(roles.mixes.size(), 1U);
  EXPECT_EQ(roles.mixes[0].index, 2);
  EXPECT_THAT(ControlsOn(roles, "taught dial box", show::MixLevel(0)), ElementsAre("dial 8"));
}

TEST_F(TaughtTest, RefusesAFileThatIsWrongAndOneWithoutTablesOfItsOwn) {
  const Taught taught = By(Device::kLeftStick, "hat x", "head_yaw", Level::kHeadYaw);
  const auto refused = [&](const char* text) {
    const auto with = Teach(text, "roles.toml", items_, below_, taught);
    return with ? std::string("taught") : with.error().message();
  };
  EXPECT_THAT(refused("[[role]]\nname = \"hed\"\n"), AllOf(HasSubstr("roles.toml:2"), HasSubstr("hed")));
  EXPECT_THAT(
      refused("role = [{ name = \"head\", map = [{ control = \"twist\", level = \"head_yaw\" }] }]\n"),
      HasSubstr("not tables of their own"));
  const auto unreadable =
      refused("[[role]]\nname = \"head\"\nmap = [{ control = \"y\", level = \"brow\" }]\n");
  EXPECT_NE(unreadable, "taught") << "a list in one line takes no further table";
}

TEST_F(TaughtTest, LearnsButtonsBesideRoles) {
  LearnButton(4, "cue go");
  Learn(By(Device::kDialBox, "dial 3", "head_yaw", Level::kHeadYaw));
  LearnButton(6, "expression angry");
  Learn(By(Device::kDialBox, "dial 4", "head_yaw", Level::kHeadYaw));
  LearnButton(4, "face kaori");
  ASSERT_EQ(besides_.buttons.size(), 2U) << text_;
  EXPECT_EQ(NameOf(besides_.buttons[0].call, items_), "expression angry");
  EXPECT_EQ(besides_.buttons[1].button, 4);
  EXPECT_EQ(NameOf(besides_.buttons[1].call, items_), "face kaori") << "in place of GO";
  const show::Roles roles = Learn(By(Device::kDialBox, "dial 5", "brow", Level::kBrow));
  EXPECT_THAT(ControlsOn(roles, "taught dial box", Level::kHeadYaw), ElementsAre("dial 4"));
  EXPECT_THAT(ControlsOn(roles, "taught dial box", Level::kBrow), ElementsAre("dial 5"));
}

TEST_F(TaughtTest, KeepsWhatAPersonWroteBetweenButtons) {
  text_ =
      "[[button]]\nnumber = 5  # the large one\ncall = \"cue go\"\n\n# Old habits:\n[[button]]\nnumber = "
      "6\ncall = \"cue back\"\n";
  LearnButton(4, "cue panic");
  EXPECT_EQ(text_,
            "\n# Old habits:\n[[button]]\nnumber = 6\ncall = \"cue back\"\n\n[[button]]\nnumber = 5\ncall = "
            "\"cue panic\"\n");
  EXPECT_FALSE(Teach("button = [{ number = 5, call = \"cue go\" }]\n", "roles.toml", items_, below_,
                     TaughtButton{4, "cue back"}));
}

TEST_F(TaughtTest, RefusesOneRoleTooMany) {
  for (int i = 0; below_.roles.size() < show::kMostRoles; ++i)
    below_.roles.push_back(
        {.name = "further " + std::to_string(i), .device = Device::kLeftStick, .maps = {}});
  const auto with =
      Teach("", "roles.toml", items_, below_, By(Device::kDialBox, "dial 2", "head_yaw", Level::kHeadYaw));
  ASSERT_FALSE(with);
  EXPECT_THAT(with.error().message(), HasSubstr("8 at most"));
}

}  // namespace
}  // namespace kaori::roles
