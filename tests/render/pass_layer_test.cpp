// How a figure's layer becomes the picture, whichever antialiasing the canvas has.
#include "render/passes/layer.h"

#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/gl/canvas.h"
#include "render/gl/draw_state.h"
#include "render/gl/texture.h"
#include "tests/render/pass_studio.h"

namespace kaori::tests {
namespace {

using gl::Antialiasing;

// Code of linear light in the picture.
double SrgbOf(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

// A layer over a black backdrop of the canvas's size.
class LayerTest : public ::testing::TestWithParam<Antialiasing> {
 protected:
  void SetUp() override { PassStudio::Shared(); }

  // Whoever draws does so on the layer, of which everything was cleared. Gives the red of the picture, the lowest row first.
  template <class Draw>
  std::vector<int> Laid(int width_px, int height_px, Draw draw) {
    const auto canvas =
        gl::Canvas::Make({.width_px = width_px, .height_px = height_px, .antialiasing = GetParam()});
    auto pass = passes::LayerPass::Open();
    EXPECT_TRUE(canvas && pass);
    const std::size_t pixels = std::size_t(width_px) * std::size_t(height_px);
    const gl::Texture black({.width_px = width_px, .height_px = height_px},
                            {std::vector<std::byte>(pixels * 4)});
    passes::FigureRegion figure;
    figure.whole = canvas->whole();
    figure.bands[0] = canvas->whole();
    canvas->BeginLayer(figure.bands, figure.whole);
    draw(*canvas);
    pass->Lay(*canvas, figure, {black}, {});
    std::vector<std::uint8_t> bytes(pixels * 4);
    canvas->ReadPixels(bytes);
    std::vector<int> red;
    for (std::size_t i = 0; i < pixels; ++i) red.push_back(bytes[4 * i]);
    return red;
  }
  static void Colour(const gl::Box& box, float root) {
    gl::CutTo(box);
    glClearColor(root, root, root, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
};

TEST_P(LayerTest, ShowsWhatIsAllOfOneLightAsItIs) {
  // Sizes of which a third is none, too.
  for (const auto& [width, height] : {std::pair{960, 540}, {12, 9}, {31, 17}, {1, 1}, {1366, 768}}) {
    const auto red = Laid(width, height, [](const gl::Canvas& canvas) {
      Colour({0, 0, canvas.layer_width_px(), canvas.layer_height_px()}, 0.5F);
    });
    const auto [least, most] = std::ranges::minmax(red);
    EXPECT_NEAR(least, SrgbOf(0.25), 2) << width << " x " << height;
    EXPECT_LE(most - least, 1) << width << " x " << height;
  }
}

TEST_P(LayerTest, HasTheFigureWhereItWasDrawn) {
  const auto red = Laid(12, 9, [](const gl::Canvas& canvas) { Colour(canvas.OnLayer({6, 3, 3, 3}), 1); });
  for (std::size_t i = 0; i < red.size(); ++i) {
    const bool within = i % 12 >= 6 && i % 12 < 9 && i / 12 >= 3 && i / 12 < 6;
    EXPECT_NEAR(red[i], within ? 255 : 0, 1) << i % 12 << ", " << i / 12;
  }
}

INSTANTIATE_TEST_SUITE_P(With, LayerTest,
                         ::testing::Values(Antialiasing::kMultisample, Antialiasing::kSupersample),
                         [](const auto& of) {
                           return of.param == Antialiasing::kMultisample ? "FourSamples" : "ALargerLayer";
                         });

class LargerLayer : public LayerTest {};

// Three pixels lie on four texels: a pixel's light is the mean of what it covers, and no mean of codes.
TEST_P(LargerLayer, IsMadeSmallerByTheMeanOfItsLight) {
  for (int texel = 0; texel < 4; ++texel) {
    const auto red = Laid(3, 3, [&](const gl::Canvas& canvas) {
      EXPECT_EQ(canvas.layer_width_px(), 4);
      Colour({texel, 0, 1, canvas.layer_height_px()}, 1);
    });
    const double covered[4][3] = {{0.75, 0, 0}, {0.25, 0.5, 0}, {0, 0.5, 0.25}, {0, 0, 0.75}};
    for (std::size_t pixel = 0; pixel < 3; ++pixel)
      EXPECT_NEAR(red[pixel], SrgbOf(covered[texel][pixel]), 2) << texel << ", " << pixel;
  }
}

TEST_P(LargerLayer, HoldsBoxesOfThePictureWhole) {
  const auto canvas = gl::Canvas::Make({.width_px = 1366, .height_px = 768, .antialiasing = GetParam()});
  ASSERT_TRUE(canvas);
  EXPECT_EQ(canvas->layer_width_px(), 1822);
  EXPECT_EQ(canvas->layer_height_px(), 1024);
  const gl::Box all = canvas->OnLayer(canvas->whole());
  EXPECT_EQ(all.width_px, 1822);
  EXPECT_EQ(all.height_px, 1024);
  for (int left = 0; left < 1366; left += 7) {
    const gl::Box box = canvas->OnLayer({left, left / 2, 5, 3});
    EXPECT_LE(box.left_px, left * 1822.0 / 1366);
    EXPECT_GE(box.left_px + box.width_px, std::min((left + 5) * 1822.0 / 1366, 1822.0));
    EXPECT_LE(box.bottom_px, left / 2 * 4.0 / 3 + 1e-9);
    EXPECT_GE(box.bottom_px + box.height_px, (left / 2 + 3) * 4.0 / 3 - 1e-9);
  }
  EXPECT_TRUE(canvas->OnLayer({5, 5, 0, 3}).empty());
}

INSTANTIATE_TEST_SUITE_P(Of, LargerLayer, ::testing::Values(Antialiasing::kSupersample),
                         [](const auto&) { return "OneSample"; });

TEST(Painter, SparesAProcessorTheSamplesOfSmallTriangles) {
  const auto& context = PassStudio::Shared().context();
  const auto painter = passes::Painter::Open(context, PassStudio::Shared().cast());
  ASSERT_TRUE(painter);
  const bool by_processor = passes::QualityFor(context.renderer()) == passes::Quality::kBasic;
  EXPECT_EQ((*painter)->antialiasing(),
            by_processor ? Antialiasing::kSupersample : Antialiasing::kMultisample);
  ASSERT_TRUE((*painter)->SetQuality(passes::Quality::kFine));
  EXPECT_EQ((*painter)->antialiasing(), Antialiasing::kMultisample) << "as a graphics card draws it";
}

}  // namespace
}  // namespace kaori::tests
