#include <gmock/gmock.h>

#include "appliance/authoring/import/role_table.h"
#include "appliance/authoring/import/roles.h"

namespace kaori::import {
namespace {

std::string Said(const char* name, NameOrigin origin = NameOrigin::kTarget) {
  const auto meaning = MeaningOf(name, origin);
  return meaning ? std::string(NameOf(meaning->style)) + " " + meaning->name : "";
}

std::vector<std::optional<Meaning>> Meanings(const std::vector<const char*>& names,
                                             NameOrigin origin = NameOrigin::kTarget) {
  std::vector<std::optional<Meaning>> meanings;
  for (const char* name : names) meanings.push_back(MeaningOf(name, origin));
  return meanings;
}

const Role* Find(const std::vector<Role>& roles, std::string_view name) {
  const auto role = std::ranges::find(roles, name, &Role::name);
  return role == roles.end() ? nullptr : &*role;
}

TEST(Roles, KnowArkitHoweverItIsSpelled) {
  for (const char* name :
       {"eyeBlinkLeft", "EyeBlinkLeft", "eye_blink_left", "eyeBlink_L", "eyeBlink.L", "eye blink left",
        "EyeBlinkL", "head_geo.eyeBlinkLeft", "blendShape1.eyeBlink_L", "Face:eyeBlinkLeft"})
    EXPECT_EQ(Said(name), "ARKit eyeBlinkLeft") << name;
}

TEST(Roles, KnowAllFiftyTwoNamesOfArkit) {
  EXPECT_EQ(NamesOf(NameStyle::kArkit).size(), 52U);
  for (const std::string_view name : NamesOf(NameStyle::kArkit))
    EXPECT_EQ(Said(std::string(name).c_str()), "ARKit " + std::string(name));
}

TEST(Roles, KnowVisemesAndPlainWords) {
  EXPECT_EQ(Said("viseme_aa"), "viseme viseme_aa");
  EXPECT_EQ(Said("Viseme PP"), "viseme viseme_PP");
  EXPECT_EQ(Said("blink_L"), "plain blink_left");
  EXPECT_EQ(Said("Brow-Raise.R"), "plain brow_up_right");
  EXPECT_EQ(Said("Mouth Open"), "plain mouth_open");
}

TEST(Roles, KnowTheNamesOfVrmInPresetsAlone) {
  EXPECT_EQ(Said("blink_l", NameOrigin::kPreset), "VRM 0.x blink_l");
  EXPECT_EQ(Said("blinkLeft", NameOrigin::kPreset), "VRM 1.0 blinkLeft");
  EXPECT_EQ(Said("joy", NameOrigin::kPreset), "VRM 0.x joy");
  EXPECT_EQ(Said("joy"), "");
}

TEST(Roles, AreSumsOfWhatAStyleHas) {
  const auto roles = FindRoles(Meanings({"jawOpen", "browInnerUp", "browOuterUpLeft", "mouthFunnel"}));
  const Role* brow = Find(roles, "brow_up_left");
  ASSERT_NE(brow, nullptr);
  ASSERT_EQ(brow->parts.size(), 2U);
  EXPECT_EQ(brow->parts[0].shape, 2U);
  EXPECT_EQ(brow->parts[1].shape, 1U);
  EXPECT_FLOAT_EQ(brow->parts[1].weight, 0.5F);
  EXPECT_EQ(Find(roles, "brow_up_right"), nullptr);
  EXPECT_NE(Find(roles, "mouth_open_narrow"), nullptr);
}

TEST(Roles, AreMadeOfVrmPresetsToo) {
  for (const auto& [names, style] :
       {std::pair{std::vector<const char*>{"a", "i", "u", "e", "o", "blink_l", "blink_r"}, NameStyle::kVrm0},
        std::pair{std::vector<const char*>{"aa", "ih", "ou", "ee", "oh", "blinkLeft", "blinkRight"},
                  NameStyle::kVrm1}}) {
    const auto roles = FindRoles(Meanings(names, NameOrigin::kPreset));
    for (const char* role : {"a", "i", "u", "e", "o", "blink_left", "blink_right"}) {
      ASSERT_NE(Find(roles, role), nullptr) << role;
      EXPECT_EQ(Find(roles, role)->style, style);
    }
  }
}

TEST(Roles, LeaveUnknownNamesAlone) {
  for (const char* name : {"", "L", "_", "target 7", "Fcl_HA_Fung1", "wibble_left"})
    EXPECT_EQ(Said(name), "") << name;
}

TEST(Roles, NeedOnlyShapesThatTheirStylesHave) {
  for (const RoleEntry& entry : RoleTable())
    EXPECT_NE(std::ranges::find(NamesOf(entry.style), entry.shape), NamesOf(entry.style).end())
        << entry.shape;
}

}  // namespace
}  // namespace kaori::import
