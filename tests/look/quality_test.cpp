// All qualities of drawing show the same faces; the finer ones more of them. Pairs are written beside the build, to be
// looked at: look/quality-FACE.png, basic on the left, the finest on the right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "render/gl/canvas.h"
#include "render/gl/context.h"
#include "render/image/png.h"
#include "render/passes/painter.h"
#include "render/passes/quality.h"
#include "tests/look/report.h"

namespace kaori {
namespace {

using passes::Quality;

constexpr int kPair_width_px = 640, kPair_height_px = 540;

double MeanDifference(const image::Picture& a, const image::Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgbx.size(); ++i)
    if (i % 4 != 3) sum += std::abs(int{a.rgbx[i]} - int{b.rgbx[i]});
  return sum / (0.75 * static_cast<double>(a.rgbx.size()));
}

class QualityTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto show = show::LoadPack(KAORI_PACK);
    ASSERT_TRUE(show) << show.error().message();
    cast_ = std::make_unique<face::Cast>(std::move(show->cast));
    auto context = gl::Context::Open();
    ASSERT_TRUE(context) << context.error().message();
    context_ = std::move(*context);
    auto painter = passes::Painter::Open(*context_, *cast_);
    ASSERT_TRUE(painter) << painter.error().message();
    painter_ = std::move(*painter);
  }
  static void TearDownTestSuite() {
    painter_.reset();
    context_.reset();
    cast_.reset();
  }

  // With raised brows, so that a forehead folds where it is drawn finely.
  static scene::Scene SceneOf(std::uint16_t face) {
    scene::Scene scene;
    const auto raised = std::ranges::find(cast_->expressions, "surprised", &face::Expression::name);
    scene.weights.faces.Push(face, 1);
    scene.weights.expressions.Push(static_cast<std::uint16_t>(raised - cast_->expressions.begin()), 1);
    scene.head.yaw_rad = -0.25F;
    return scene;
  }
  static image::Picture Draw(const scene::Scene& scene, Quality quality) {
    const auto set = painter_->SetQuality(quality);
    EXPECT_TRUE(set) << set.error().message();
    EXPECT_EQ(painter_->quality(), quality);
    const auto canvas = gl::Canvas::Make(
        {.width_px = kPair_width_px, .height_px = kPair_height_px, .antialiasing = painter_->antialiasing()});
    EXPECT_TRUE(canvas) << canvas.error().message();
    painter_->Draw(scene, *canvas);
    auto picture = image::Picture::Blank(kPair_width_px, kPair_height_px);
    canvas->ReadPixels(picture.rgbx);
    return picture;
  }

  static std::unique_ptr<face::Cast> cast_;
  static std::unique_ptr<gl::Context> context_;
  static std::unique_ptr<passes::Painter> painter_;
};
std::unique_ptr<face::Cast> QualityTest::cast_;
std::unique_ptr<gl::Context> QualityTest::context_;
std::unique_ptr<passes::Painter> QualityTest::painter_;

TEST_F(QualityTest, ShowsTheSameFaces) {
  const std::filesystem::path folder = KAORI_LOOK_PICTURES;
  std::filesystem::create_directories(folder);
  double farthest = 0;
  for (std::uint16_t face = 0; face < cast_->faces.size(); ++face) {
    const std::string& name = cast_->faces[face].name;
    const auto basic = Draw(SceneOf(face), Quality::kBasic);
    const auto fine = Draw(SceneOf(face), Quality::kFine);
    const auto finest = Draw(SceneOf(face), Quality::kFinest);
    auto pair = image::Picture::Blank(2 * kPair_width_px, kPair_height_px);
    image::Paste(basic, pair, 0, 0);
    image::Paste(finest, pair, kPair_width_px, 0);
    EXPECT_TRUE(image::WritePng(folder / ("quality-" + name + ".png"), pair));
    const double mean = MeanDifference(basic, fine);
    EXPECT_GT(mean, 0.05) << name << ": nothing is drawn finely";
    EXPECT_LT(mean, 4) << name << ": is another face";
    EXPECT_LT(MeanDifference(fine, finest), 1.5) << name << ": light within skin makes another face";
    farthest = std::max(farthest, mean);
  }
  tests::Report("quality_mean_difference", farthest);
}

// The lamp goes from high up to the front: what lay in the shadow of chin and hair is lit then.
TEST_F(QualityTest, ThrowsShadowsThatFollowTheLamp) {
  scene::Scene from_above = SceneOf(0);
  from_above.light.key = {0, 2.0F, 1.0F};
  scene::Scene from_ahead = SceneOf(0);
  from_ahead.light.key = {0, 0.1F, 1.0F};
  const double above = MeanDifference(Draw(from_above, Quality::kBasic), Draw(from_above, Quality::kFine));
  const double ahead = MeanDifference(Draw(from_ahead, Quality::kBasic), Draw(from_ahead, Quality::kFine));
  EXPECT_GT(above, 1.5 * ahead);
}

TEST(QualityOfADriver, IsBasicWhereAProcessorDraws) {
  EXPECT_EQ(passes::QualityFor("llvmpipe (LLVM 15.0.6, 256 bits)"), Quality::kBasic);
  EXPECT_EQ(passes::QualityFor("virgl (LLVMPIPE (LLVM 15.0.6))"), Quality::kBasic);
  EXPECT_EQ(passes::QualityFor("softpipe"), Quality::kBasic);
  EXPECT_EQ(passes::QualityFor("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"), Quality::kFinest);
  EXPECT_EQ(passes::QualityFor("AMD Radeon Graphics (radeonsi, renoir)"), Quality::kFinest);
}

}  // namespace
}  // namespace kaori
