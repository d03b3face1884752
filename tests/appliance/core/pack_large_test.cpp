// The largest show that is promised: 100 000 triangles, 16 faces, 40 expressions; it loads, and it plays.
#include <gmock/gmock.h>

#include <set>

#include "appliance/core/show/pack.h"
#include "appliance/programs/stage/studio.h"
#include "render/face/composites.h"
#include "tests/appliance/core/large_show.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

constexpr std::size_t kMegabyte = 1'000'000;

class LargeShow : public PackTest {
 protected:
  show::Show Load() const {
    const auto file = folder_ / "large.kaori";
    EXPECT_TRUE(show::SavePack(MakeLargeShow(), file));
    auto show = show::LoadPack(file);
    EXPECT_TRUE(show) << show.error().message();
    RecordProperty("pack_mb", static_cast<int>(std::filesystem::file_size(file) / kMegabyte));
    return std::move(*show);
  }

  static std::uint64_t Sum(const std::vector<std::uint8_t>& bytes) {
    std::uint64_t sum = 0;
    for (const std::uint8_t byte : bytes) sum = sum * 31 + byte;
    return sum;
  }
};

TEST_F(LargeShow, IsAsLargeAsIsPromised) {
  const auto show = MakeLargeShow();
  EXPECT_GE(show.cast.topology.fine.triangles.size(), 100'000U);
  EXPECT_EQ(show.cast.faces.size(), 16U);
  EXPECT_EQ(show.cast.expressions.size(), 40U);
}

// Everything that is called up lies in memory: 16 faces in 40 expressions.
TEST_F(LargeShow, KeepsAllItsCompositesInAHundredMegabytes) {
  const auto show = MakeLargeShow();
  const face::Composites composites(show.cast);
  RecordProperty("composites_mb", static_cast<int>(composites.bytes() / kMegabyte));
  EXPECT_LE(composites.bytes(), 100 * kMegabyte);
}

TEST_F(LargeShow, LoadsAndPlaysTenFrames) {
  const auto studio = stage::Studio::Open(Load());
  ASSERT_TRUE(studio) << studio.error().message();
  std::vector<std::uint8_t> bytes(std::size_t{320} * 240 * 4);
  std::set<std::uint64_t> pictures;
  for (std::uint16_t frame = 0; frame < 10; ++frame) {
    scene::Scene scene;
    scene.weights.faces.Push(static_cast<std::uint16_t>(frame % 16), 0.5F);
    scene.weights.faces.Push(static_cast<std::uint16_t>((frame + 5) % 16), 0.5F);
    scene.weights.expressions.Push(static_cast<std::uint16_t>(4 * frame), 1);
    ASSERT_TRUE((*studio)->Draw(scene, {320, 240, ports::PixelMemory{bytes}}));
    pictures.insert(Sum(bytes));
  }
  EXPECT_GE(pictures.size(), 6U) << "faces and expressions that differ make pictures that differ";
}

}  // namespace
}  // namespace kaori::tests
