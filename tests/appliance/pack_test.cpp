// Show packs: what goes in comes out, and what is not a sound pack is refused with one line.
#include "appliance/show/pack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "appliance/show/check.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::show {
namespace {

namespace fs = std::filesystem;

Show SmallShow() {
  Show show;
  show.name = "small";
  show.cast = kaori::testing::MakeSyntheticCast({.columns = 16, .rows = 12});
  show.buttons[3] = {CallKind::kFace, 2};
  show.scenes.resize(1);
  show.scenes[0].name = "opening";
  show.scenes[0].backdrop.top = {0.1F, 0.2F, 0.3F};
  show.takes = {{"nod", 0x1E, {{TakeTarget::kHeadPitch, 0, {{0, 0}, {0.5F, 0.3F}, {1, 0}}}}}};
  show.channels.brow_frown = 4;
  return show;
}

class PackTest : public ::testing::Test {
 protected:
  PackTest() : folder_(fs::temp_directory_path() / ("kaori-pack-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~PackTest() override { fs::remove_all(folder_); }

  fs::path Write(const std::vector<std::uint8_t>& bytes) const {
    const fs::path file = folder_ / "show.kaori";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file;
  }

  fs::path folder_;
};

TEST_F(PackTest, AShowComesOutAsItWentIn) {
  const Show show = SmallShow();
  ASSERT_THAT(CheckShow(show), ::testing::IsEmpty());
  const fs::path file = folder_ / "small.kaori";
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

TEST_F(PackTest, ATruncatedPackIsRefusedWithOneLine) {
  auto bytes = EncodePack(SmallShow());
  bytes.resize(bytes.size() / 2);
  const auto loaded = LoadPack(Write(bytes));
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().attempt, ::testing::HasSubstr("show.kaori is no whole show pack"));
  EXPECT_EQ(loaded.error().attempt.find('\n'), std::string::npos);
}

TEST_F(PackTest, AMissingAnEmptyAndAForeignFileAreNamed) {
  EXPECT_THAT(LoadPack(folder_ / "nowhere").error().message(), ::testing::HasSubstr("No such file"));
  EXPECT_THAT(LoadPack(Write({})).error().attempt, ::testing::HasSubstr("is empty"));
  EXPECT_THAT(LoadPack(Write(std::vector<std::uint8_t>(4096, 'x'))).error().attempt,
              ::testing::HasSubstr("no whole show pack"));
}

TEST_F(PackTest, FlippedBytesNeverCrashAndNeverPassUnsound) {
  const auto sound = EncodePack(SmallShow());
  std::mt19937 random(11);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    auto bytes = sound;
    for (int flips = 0; flips < 4; ++flips) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    if (const auto loaded = LoadPack(Write(bytes)); !loaded)
      ++refused;
    else
      EXPECT_THAT(CheckShow(*loaded), ::testing::IsEmpty());
  }
  EXPECT_GT(refused, 0);
}

TEST_F(PackTest, AFaceThatIsNoFaceIsRefusedByName) {
  Show show = SmallShow();
  show.cast.faces[1].positions[7].y = std::numeric_limits<float>::quiet_NaN();
  const auto loaded = LoadPack(Write(EncodePack(show)));
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().attempt, ::testing::HasSubstr(show.cast.faces[1].name));
}

TEST_F(PackTest, AFailedSaveLeavesTheOldPackWhole) {
  const fs::path file = folder_ / "small.kaori";
  ASSERT_TRUE(SavePack(SmallShow(), file));
  fs::create_directory(file.string() + ".new");  // The temporary file cannot be opened.
  EXPECT_FALSE(SavePack(SmallShow(), file));
  EXPECT_TRUE(LoadPack(file));
}

TEST(CheckShow, NamesEveryControlThatCallsNothing) {
  Show show = SmallShow();
  show.buttons[0] = {CallKind::kExpression, 99};
  show.scenes[0].face = 42;
  show.takes[0].curves[0].keys.back().value = 1;
  EXPECT_THAT(CheckShow(show), ::testing::UnorderedElementsAre(::testing::HasSubstr("button 1"),
                                                               ::testing::HasSubstr("scene \"opening\""),
                                                               ::testing::HasSubstr("take \"nod\"")));
}

}  // namespace
}  // namespace kaori::show
