// Show packs: what goes in comes out, and what is not a sound show is refused with one line.
#include "appliance/show/pack.h"

#include <gmock/gmock.h>

#include <limits>

#include "appliance/show/check.h"
#include "tests/appliance/pack_fixture.h"

namespace kaori::testing {
namespace {

using show::EncodePack;
using show::LoadPack;
using show::SavePack;
using show::Show;
using ::testing::HasSubstr;

TEST_F(PackTest, AShowComesOutAsItWentIn) {
  const Show show = SmallShow();
  ASSERT_THAT(CheckShow(show), ::testing::IsEmpty());
  const auto file = folder_ / "small.kaori";
  ASSERT_TRUE(SavePack(show, file));
  const auto loaded = LoadPack(file);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->name, "small");
  EXPECT_EQ(loaded->cast.faces[2].positions, show.cast.faces[2].positions);
  EXPECT_EQ(loaded->cast.net.to_cage.weight, show.cast.net.to_cage.weight);
  EXPECT_EQ(loaded->cast.expressions[1].displacement, show.cast.expressions[1].displacement);
  EXPECT_EQ(loaded->cast.topology.lids[1].upper, show.cast.topology.lids[1].upper);
  EXPECT_EQ(loaded->buttons[3].index, 2);
  EXPECT_EQ(loaded->takes[0].curves[0].keys[1].value, 0.3F);
  EXPECT_EQ(loaded->scenes[0].backdrop.top, show.scenes[0].backdrop.top);
  EXPECT_EQ(loaded->channels.brow_frown, 4);
  EXPECT_EQ(EncodePack(*loaded), EncodePack(show)) << "a second writing gives the same bytes";
}

TEST_F(PackTest, AMissingAnEmptyAndAForeignFileAreNamed) {
  EXPECT_THAT(LoadPack(folder_ / "nowhere").error().message(), HasSubstr("nowhere: No such file"));
  EXPECT_THAT(LoadPack(folder_).error().message(), HasSubstr("Is a directory"));
  EXPECT_THAT(LoadPack("/dev/zero").error().message(), HasSubstr("/dev/zero is no file"));
  EXPECT_THAT(LoadPack(Write({})).error().attempt, HasSubstr("is empty"));
  EXPECT_THAT(LoadPack(Write(std::vector<std::uint8_t>(4096, 'x'))).error().attempt,
              HasSubstr("show.kaori is no show pack"));
}

TEST_F(PackTest, AFaceThatIsNoFaceIsRefusedByName) {
  Show show = SmallShow();
  show.cast.faces[1].positions[7].y = std::numeric_limits<float>::quiet_NaN();
  const auto loaded = LoadPack(Write(EncodePack(show)));
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().attempt, HasSubstr(show.cast.faces[1].name));
}

TEST(CheckShow, NamesEveryControlThatCallsNothing) {
  Show show = SmallShow();
  show.buttons[0] = {show::CallKind::kExpression, 99};
  show.scenes[0].face = 42;
  show.takes[0].curves[0].keys.back().value = 1;
  EXPECT_THAT(show::CheckShow(show),
              ::testing::UnorderedElementsAre(HasSubstr("button 1"), HasSubstr("scene \"opening\""),
                                              HasSubstr("take \"nod\"")));
}

}  // namespace
}  // namespace kaori::testing
