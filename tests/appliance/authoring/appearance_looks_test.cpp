// Files of looks: the default ones are sound, and a fault names file, item and reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/dress.h"
#include "appliance/authoring/appearance/looks.h"
#include "tests/appliance/authoring/appearance_fixture.h"

namespace kaori::appearance {
namespace {

using ::testing::HasSubstr;

std::string TextOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

// Kaori's look with `from` replaced by `to`, in a file of its own that goes when the test ends.
class ChangedLook {
 public:
  ChangedLook(const std::string& from, const std::string& to) {
    std::string text = TextOf(ShowFolder() / "looks/kaori.toml");
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "kaori.toml does not hold: " << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    path_ = std::filesystem::temp_directory_path() / ("kaori-look-" + std::to_string(::getpid()) + ".toml");
    std::ofstream(path_) << text;
  }
  ~ChangedLook() { std::filesystem::remove(path_); }

  std::string Fault() const {
    const Result<FaceLook> look = ReadLook(path_);
    return look ? "no fault" : look.error().message();
  }
  std::string name() const { return path_.filename().string(); }

 private:
  std::filesystem::path path_;
};

TEST(AppearanceLooks, OfTheDefaultShowAreAllSound) {
  for (const char* name :
       {"kaori", "poster", "round", "old_woman", "child", "narrator", "mask", "robot", "dog", "kettle"}) {
    const Result<FaceLook> look = ReadLook(ShowFolder() / "looks" / (std::string(name) + ".toml"));
    EXPECT_TRUE(look) << look.error().message();
  }
}

TEST(AppearanceLooks, NameFileItemAndReasonOfAWrongColour) {
  const ChangedLook look("base = \"#f2cbb3\"", "base = \"pink\"");
  EXPECT_THAT(look.Fault(), HasSubstr(look.name()));
  EXPECT_THAT(look.Fault(), HasSubstr("skin.base: must be a colour"));
}

TEST(AppearanceLooks, NameAnUnknownItem) {
  const ChangedLook look("gloss = 0.10", "glossy = 0.10");
  EXPECT_THAT(look.Fault(), HasSubstr("skin.glossy: is not known here"));
}

TEST(AppearanceLooks, NameAValueOutOfRange) {
  const ChangedLook look("amount = 0.82", "amount = 8.2");
  EXPECT_THAT(look.Fault(), HasSubstr("lips.amount: must lie between 0 and 1"));
}

TEST(AppearanceLooks, NameATableThatDoesNotRise) {
  const ChangedLook look("ends = [[54, -7.7], [90, -8.2]", "ends = [[54, -7.7], [40, -8.2]");
  EXPECT_THAT(look.Fault(), HasSubstr("hair.ends: the first number of each pair must rise"));
}

TEST(AppearanceLooks, NameAnUnknownCutAndThoseThatThereAre) {
  const ChangedLook look("cut = \"blouse\"", "cut = \"toga\"");
  EXPECT_THAT(look.Fault(), HasSubstr("clothes.cut: must be one of \"blouse\", \"knit\""));
}

TEST(AppearanceLooks, NameAnUnknownShapeOfGear) {
  const ChangedLook look("[clothes]", "[[gear]]\nshape = \"hat\"\ncolour = \"#000000\"\n[clothes]");
  EXPECT_THAT(look.Fault(), HasSubstr("must be one of \"rod\", \"ring\", \"ball\", \"disc\""));
}

TEST(AppearanceLooks, WantOfGearTheRadiiThatItsShapeHas) {
  const auto fault_of = [](const std::string& shape, const std::string& radii) {
    return ChangedLook("[clothes]",
                       "[[gear]]\nshape = \"" + shape + "\"\ncolour = \"#000000\"\n" + radii + "\n[clothes]")
        .Fault();
  };
  const std::string rod = "path = [[0, 0, 0], [0, 9, 0]]\n", other = "centre = [0, 9, 0]\n";
  EXPECT_EQ(fault_of("rod", rod + "radii = [0.2, 0, 0]"), "no fault");
  EXPECT_EQ(fault_of("disc", other + "radii = [0.2, 0, 0]"), "no fault");
  EXPECT_EQ(fault_of("ring", other + "radii = [0.2, 0.3, 0]"), "no fault");
  for (const auto& [shape, radii] :
       {std::pair{"rod", "radii = [0, 1, 1]"}, std::pair{"ring", "radii = [1, 0, 1]"},
        std::pair{"ball", "radii = [1, 1, 0]"}, std::pair{"disc", "radius = 0"}})
    EXPECT_THAT(fault_of(shape, (shape == std::string("rod") ? rod : other) + radii),
                HasSubstr("radii: must be greater than 0"))
        << shape;
}

TEST(AppearanceLooks, NameANumberThatIsNotWhole) {
  for (const char* seed : {"1.5", "-1", "1e300"})
    EXPECT_THAT(ChangedLook("seed = 1\n", std::string("seed = ") + seed + "\n").Fault(),
                HasSubstr("seed: is "))
        << seed;
}

TEST(AppearanceLooks, NameABundleOfTooManyLocks) {
  const ChangedLook look("[clothes]",
                         "[[hair.bundle]]\npath = [[0, 9, 0], [0, 12, 0]]\nradius = [[0, 1], [1, 2]]\n"
                         "locks = 200\n[clothes]");
  EXPECT_THAT(look.Fault(), HasSubstr("locks: must lie between 2 and 24"));
}

TEST(AppearanceLooks, NameALookThatIsMissing) {
  EXPECT_THAT(ReadLook(ShowFolder() / "looks/nobody.toml").error().message(), HasSubstr("nobody.toml"));
}

TEST(AppearanceDress, RefusesATextureSizeThatIsNoPowerOfTwo) {
  face::Cast cast = SculptedCast();
  EXPECT_FALSE(Dress(ShowFolder(), cast, {.texture_px = 1000}));
}

TEST(AppearanceColour, GoesThereAndBack) {
  for (const char* hex : {"#000000", "#ffffff", "#808080", "#f2cbb3"}) {
    const glm::vec3 c = Hex(hex);
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", ToSrgbByte(c.r), ToSrgbByte(c.g), ToSrgbByte(c.b));
    EXPECT_STREQ(text, hex);
  }
  EXPECT_FALSE(ColourFromHex("#12345"));
  EXPECT_FALSE(ColourFromHex("#12345g"));
}

}  // namespace
}  // namespace kaori::appearance
