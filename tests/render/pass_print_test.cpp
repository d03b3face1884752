// A face that is a poster: dots and few inks, over all that it wears, faded in and out like any look.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

using tests::Difference;
using tests::PassStudio;
using tests::Picture;

constexpr int kPrintWidth_px = 400;
constexpr int kPrintHeight_px = 300;

// The studio's cast, its first face printed by so much.
class Press {
 public:
  explicit Press(float print) : cast_(PassStudio::Shared().cast()) {
    cast_.faces[0].surface.print = print;
    auto painter = passes::Painter::Open(PassStudio::Shared().context(), cast_);
    EXPECT_TRUE(painter) << painter.error().message();
    painter_ = std::move(*painter);
  }

  Picture Draw(const scene::Scene& scene) {
    const auto canvas = gl::Canvas::Make({.width_px = kPrintWidth_px, .height_px = kPrintHeight_px});
    EXPECT_TRUE(canvas) << canvas.error().message();
    Picture picture{kPrintWidth_px, kPrintHeight_px, {}};
    picture.bytes.resize(std::size_t{kPrintWidth_px} * kPrintHeight_px * 4);
    painter_->Draw(scene, *canvas);
    canvas->ReadPixels(picture.bytes);
    return picture;
  }

 private:
  face::Cast cast_;
  std::unique_ptr<passes::Painter> painter_;
};

scene::Scene Plain() {
  scene::Scene scene = tests::PlainScene(scene::Style::kSoft);
  scene.backdrop = {{0.02F, 0.02F, 0.02F}, {0.02F, 0.02F, 0.02F}};
  return scene;
}

// Mean difference of neighbours in the middle of the picture, where the face is.
double Grain(const Picture& picture) {
  double sum = 0;
  int count = 0;
  for (int y = 100; y < 200; ++y)
    for (int x = 140; x < 260; ++x, ++count)
      sum += std::abs(int{picture.at(x, y)[2]} - int{picture.at(x + 1, y)[2]});
  return sum / count;
}

TEST(Print, IsMadeOfDots) {
  const Picture plain = Press(0).Draw(Plain());
  const Picture printed = Press(1).Draw(Plain());
  EXPECT_GT(Grain(printed), 2 * Grain(plain));
}

TEST(Print, FadesInWithItsFace) {
  const Picture plain = Press(0).Draw(Plain());
  const double half = Difference(Press(0.5F).Draw(Plain()), plain);
  const double whole = Difference(Press(1).Draw(Plain()), plain);
  EXPECT_GT(half, 0.2 * whole);
  EXPECT_LT(half, 0.8 * whole);
}

TEST(Print, ReachesHairAndClothesButNotTheBackdrop) {
  const Picture plain = Press(0).Draw(Plain());
  const Picture printed = Press(1).Draw(Plain());
  const auto changed = [&](int x, int y) {
    int most = 0;
    for (int dx = -4; dx <= 4; ++dx)
      for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(plain.at(x + dx, y)[c] - printed.at(x + dx, y)[c]));
    return most;
  };
  EXPECT_GT(changed(200, 222), 20) << "hair";
  EXPECT_GT(changed(200, 8), 20) << "clothes";
  EXPECT_EQ(changed(20, 280), 0) << "backdrop";
}

TEST(Print, IsBlackWithoutLight) {
  scene::Scene scene = Plain();
  scene.light.exposure = 0;
  const Picture picture = Press(1).Draw(scene);
  for (std::size_t i = 0; i < picture.bytes.size(); ++i)
    ASSERT_TRUE(i % 4 == 3 || picture.bytes[i] == 0) << i;
}

TEST(Print, IsNotOfTheWireframe) {
  scene::Scene scene = Plain();
  scene.styles = {1, 0, 0, 0, 0};
  EXPECT_EQ(Press(1).Draw(scene).bytes, Press(0).Draw(scene).bytes);
}

}  // namespace
}  // namespace kaori
