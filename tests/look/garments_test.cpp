// Garments while faces cross-fade: which pixels each of them contributes to.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "render/passes/painter.h"
#include "tests/look/look_pack.h"
#include "tests/look/regions.h"
#include "tests/look/report.h"

namespace kaori {
namespace {

constexpr int kWidth_px = 120;
constexpr int kHeight_px = 132;

using Bytes = std::vector<std::uint8_t>;
using tests::Pixels;

scene::Scene Sharing(std::uint16_t a, std::uint16_t b, float share_of_b) {
  scene::Scene scene;
  scene.weights.faces.Push(a, 1 - share_of_b);
  scene.weights.faces.Push(b, share_of_b);
  scene.weights.expressions.Push(0, 1);
  scene.styles = {};
  scene.styles[static_cast<std::size_t>(scene::Style::kSoft)] = 1;
  return scene;
}

// Draws the cast with the garments of one face in the light and all others in the dark, or with all in the dark: by
// their baked shade, since garments that replace each other are of one colour. A pixel to which the face's garments
// contribute differs between the two.
class Garments : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    cast_ = std::make_unique<face::Cast>(tests::ClothedCast());
    for (face::Prop& prop : cast_->props) Paint(prop, glm::vec3(1), 0);
    auto context = gl::Context::Open();
    ASSERT_TRUE(context) << context.error().message();
    context_ = std::move(*context);
    // Borders between garments lie at pixels of the layer: here at those of the picture, none of which they blend.
    auto canvas = gl::Canvas::Make(
        {.width_px = kWidth_px, .height_px = kHeight_px, .antialiasing = gl::Antialiasing::kMultisample});
    ASSERT_TRUE(canvas) << canvas.error().message();
    canvas_.emplace(std::move(*canvas));
    black_ = OpenPainter();
    for (const face::Face& f : cast_->faces) {
      PaintWorn(f, glm::vec3(1), 1);
      white_.push_back(OpenPainter());
      PaintWorn(f, glm::vec3(1), 0);
    }
  }
  static void TearDownTestSuite() {
    white_.clear();
    black_.reset();
    canvas_.reset();
    context_.reset();
    cast_.reset();
  }

  static void Paint(face::Prop& prop, glm::vec3 colour, float shade) {
    prop.colour = colour;
    for (face::PropVertex& v : prop.vertices) v.shade = shade;
  }
  static void PaintWorn(const face::Face& face, glm::vec3 colour, float shade) {
    for (const int prop : face.props) Paint(cast_->props[static_cast<std::size_t>(prop)], colour, shade);
  }

  static std::unique_ptr<passes::Painter> OpenPainter() {
    auto painter = passes::Painter::Open(*context_, *cast_);
    EXPECT_TRUE(painter) << painter.error().message();
    return painter ? std::move(*painter) : nullptr;
  }

  static Bytes Draw(passes::Painter& painter, const scene::Scene& scene) {
    painter.Draw(scene, *canvas_);
    Bytes bytes(std::size_t{kWidth_px} * kHeight_px * 4);
    canvas_->ReadPixels(bytes);
    return bytes;
  }

  // Where the face's garments contribute, beside the picture in which all are black.
  static Pixels Contributed(std::uint16_t face, const scene::Scene& scene, const Bytes& black) {
    const Bytes white = Draw(*white_[face], scene);
    Pixels pixels(black.size() / 4);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) pixels[i] = pixels[i] || white[4 * i + c] != black[4 * i + c];
    }
    return pixels;
  }
  static Pixels Contributed(std::uint16_t face, const scene::Scene& scene) {
    return Contributed(face, scene, Draw(*black_, scene));
  }

  static Pixels ContributedByBoth(std::uint16_t a, std::uint16_t b, const scene::Scene& scene) {
    const Bytes black = Draw(*black_, scene);
    Pixels of_both = Contributed(a, scene, black);
    if (a == b) return of_both;
    const Pixels of_b = Contributed(b, scene, black);
    for (std::size_t i = 0; i < of_both.size(); ++i) of_both[i] = of_both[i] || of_b[i];
    return of_both;
  }

  static std::size_t Count(const Pixels& pixels) {
    return static_cast<std::size_t>(std::ranges::count(pixels, true));
  }

  static std::uint16_t FaceCount() { return static_cast<std::uint16_t>(cast_->faces.size()); }
  static const std::string& NameOf(std::uint16_t face) { return cast_->faces[face].name; }

  static std::unique_ptr<face::Cast> cast_;
  static std::unique_ptr<gl::Context> context_;
  static std::optional<gl::Canvas> canvas_;
  static std::unique_ptr<passes::Painter> black_;
  static std::vector<std::unique_ptr<passes::Painter>> white_;
};
std::unique_ptr<face::Cast> Garments::cast_;
std::unique_ptr<gl::Context> Garments::context_;
std::optional<gl::Canvas> Garments::canvas_;
std::unique_ptr<passes::Painter> Garments::black_;
std::vector<std::unique_ptr<passes::Painter>> Garments::white_;

// morph_garment_overlap_px: over all pairs at 25, 50 and 75 %.
TEST_F(Garments, NoPixelShowsThoseOfTwoFaces) {
  std::size_t overlap_px = 0;
  std::size_t seen_px = 0;
  for (std::uint16_t a = 0; a < FaceCount(); ++a) {
    for (std::uint16_t b = a + 1; b < FaceCount(); ++b) {
      for (const float share : {0.25F, 0.5F, 0.75F}) {
        const scene::Scene scene = Sharing(a, b, share);
        const Bytes black = Draw(*black_, scene);
        const Pixels of_a = Contributed(a, scene, black);
        const Pixels of_b = Contributed(b, scene, black);
        std::size_t both_px = 0;
        for (std::size_t i = 0; i < of_a.size(); ++i) both_px += of_a[i] && of_b[i] ? 1 : 0;
        EXPECT_EQ(both_px, 0U) << NameOf(a) << " and " << NameOf(b) << " at " << share;
        overlap_px += both_px;
        seen_px += Count(of_a) + Count(of_b);
      }
    }
  }
  EXPECT_GT(seen_px, 30000U) << "the garments are hardly in the picture";
  tests::Report("morph_garment_overlap_px", static_cast<double>(overlap_px));
}

// The widest row of pixels to which garments contribute.
int WidestRow_px(const Pixels& pixels) {
  std::ptrdiff_t widest = 0;
  for (auto row = pixels.begin(); row != pixels.end(); row += kWidth_px)
    widest = std::max(widest, std::count(row, row + kWidth_px, true));
  return static_cast<int>(widest);
}

// How far clothes of all faces draw back below a place where they were wider, at most over both sides: shoulders only get wider.
int Notch_px(const Pixels& pixels) {
  int notch_px = 0;
  for (const bool left : {false, true}) {
    int widest_px = 0;
    // The picture's rows come from below.
    for (int row = kHeight_px - 1; row >= 0; --row) {
      int out_px = 0;
      for (int i = 0; i < kWidth_px / 2; ++i) {
        const int column = left ? kWidth_px / 2 - 1 - i : kWidth_px / 2 + i;
        if (pixels[static_cast<std::size_t>(row * kWidth_px + column)]) out_px = i + 1;
      }
      widest_px = std::max(widest_px, out_px);
      if (out_px > 0) notch_px = std::max(notch_px, widest_px - out_px);
    }
  }
  return notch_px;
}

// What hangs in the air: regions that do not reach the picture's lower edge.
int Hanging_px(const Pixels& pixels) {
  std::size_t hanging_px = 0;
  for (const tests::Region& region : tests::RegionsOf(pixels, kWidth_px))
    if (!region.at_bottom) hanging_px += region.size_px;
  return static_cast<int>(hanging_px);
}

// morph_shoulder_notch_px and morph_garment_hanging_px: over all pairs at 25, 50 and 75 %, beyond what either of the two has
// by itself.
TEST_F(Garments, OfOneFaceNeitherStandOffTheShouldersOfAnotherNorHangBeforeThem) {
  struct Seen {
    int notch_px = 0, hanging_px = 0;
  };
  const auto seen = [](std::uint16_t a, std::uint16_t b, float share) {
    const Pixels of_both = ContributedByBoth(a, b, Sharing(a, b, share));
    return Seen{Notch_px(of_both), Hanging_px(of_both)};
  };
  std::vector<Seen> alone;
  for (std::uint16_t face = 0; face < FaceCount(); ++face) alone.push_back(seen(face, face, 0));
  Seen worst;
  for (std::uint16_t a = 0; a < FaceCount(); ++a) {
    for (std::uint16_t b = a + 1; b < FaceCount(); ++b) {
      for (const float share : {0.25F, 0.5F, 0.75F}) {
        const Seen here = seen(a, b, share);
        const int notch_px = here.notch_px - std::max(alone[a].notch_px, alone[b].notch_px);
        const int hanging_px = here.hanging_px - std::max(alone[a].hanging_px, alone[b].hanging_px);
        EXPECT_LE(notch_px, 2) << NameOf(a) << " and " << NameOf(b) << " at " << share;
        EXPECT_LE(hanging_px, 6) << NameOf(a) << " and " << NameOf(b) << " at " << share;
        worst = {std::max(worst.notch_px, notch_px), std::max(worst.hanging_px, hanging_px)};
      }
    }
  }
  tests::Report("morph_shoulder_notch_px", worst.notch_px);
  tests::Report("morph_garment_hanging_px", worst.hanging_px);
}

// From one frame to the next: a fade of a second has thirty, and is twice as fast in its middle.
TEST_F(Garments, GiveWayFrameByFrame) {
  constexpr int kFrames = 30;
  const auto faces = {std::pair<std::uint16_t, std::uint16_t>{0, 2}, {0, 3}, {0, 8}};
  for (const auto& [a, b] : faces) {
    const auto whole_px = static_cast<int>(Count(Contributed(a, Sharing(a, b, 0))));
    int before_px = whole_px;
    for (int frame = 1; frame <= kFrames; ++frame) {
      const scene::Scene scene = Sharing(a, b, static_cast<float>(frame) / kFrames);
      const auto left_px = static_cast<int>(Count(Contributed(a, scene)));
      EXPECT_LE(std::abs(before_px - left_px), whole_px / 5)
          << NameOf(a) << " to " << NameOf(b) << " in frame " << frame;
      before_px = left_px;
    }
    EXPECT_EQ(before_px, 0);
  }
}

TEST_F(Garments, SinkWithoutGettingSmallWhereAFaceHasNoNeck) {
  const auto kettle = static_cast<std::uint16_t>(
      std::ranges::find(cast_->faces, "kettle", &face::Face::name) - cast_->faces.begin());
  ASSERT_LT(kettle, FaceCount());
  for (std::uint16_t face = 0; face < FaceCount(); ++face) {
    if (face == kettle) continue;
    const int whole_px = WidestRow_px(Contributed(face, Sharing(face, kettle, 0)));
    EXPECT_GE(WidestRow_px(Contributed(face, Sharing(face, kettle, 0.02F))), whole_px * 6 / 10)
        << NameOf(face);
    EXPECT_EQ(Count(Contributed(face, Sharing(face, kettle, 0.12F))), 0U) << NameOf(face);
  }
}

TEST_F(Garments, OfTheFaceThatLeavesAreGoneBeforeItIs) {
  for (std::uint16_t face = 1; face < FaceCount(); ++face) {
    const std::size_t whole_px = Count(Contributed(face, Sharing(0, face, 1)));
    const std::size_t left_px = Count(Contributed(face, Sharing(0, face, 0.01F)));
    EXPECT_LE(left_px, whole_px / 20) << NameOf(face);
  }
}

// So that the border between them is not seen as dots; and what comes takes over the colour little by little: at 15 % a black
// jacket is not black yet.
TEST_F(Garments, ThatReplaceEachOtherAreOfOneColour) {
  constexpr std::uint16_t kOther = 2;
  PaintWorn(cast_->faces[0], {1, 0, 0}, 1);
  PaintWorn(cast_->faces[kOther], {0, 1, 0}, 1);
  const auto painter = OpenPainter();
  PaintWorn(cast_->faces[0], glm::vec3(1), 0);
  PaintWorn(cast_->faces[kOther], glm::vec3(1), 0);
  const scene::Scene scene = Sharing(0, kOther, 0.5F);
  const Bytes picture = Draw(*painter, scene);
  const Pixels of_one = Contributed(0, scene);
  const Pixels of_other = Contributed(kOther, scene);
  std::array<double, 2> redder{};
  for (std::size_t i = 0; i < of_one.size(); ++i) {
    const int by = picture[4 * i] - picture[4 * i + 1];
    if (of_one[i]) redder[0] += by / static_cast<double>(Count(of_one));
    if (of_other[i]) redder[1] += by / static_cast<double>(Count(of_other));
  }
  EXPECT_GT(Count(of_one), 100U);
  EXPECT_GT(Count(of_other), 100U);
  EXPECT_NEAR(redder[0], redder[1], 12) << "on the one side of the border and on the other";
  const scene::Scene early = Sharing(0, kOther, 0.15F);
  const Bytes soon = Draw(*painter, early);
  const Pixels of_both = ContributedByBoth(0, kOther, early);
  int turned_px = 0;
  for (std::size_t i = 0; i < of_both.size(); ++i)
    turned_px += of_both[i] && soon[4 * i] < soon[4 * i + 1] ? 1 : 0;
  EXPECT_EQ(turned_px, 0) << "of the colour of what has 15 %";
}

TEST_F(Garments, KeepTheirPlaceWhenTheFadeTurnsBack) {
  scene::Scene there = Sharing(0, 5, 0.4F);
  scene::Scene back = Sharing(5, 0, 0.6F);
  // 1 - 0.6 is not quite 0.4, so that a pixel on the border may fall to either side.
  const Bytes one = Draw(*white_[0], there);
  const Bytes other = Draw(*white_[0], back);
  int differ = 0;
  for (std::size_t i = 0; i < one.size(); ++i) differ += std::abs(one[i] - other[i]) > 2 ? 1 : 0;
  EXPECT_LE(differ, 12);
}

}  // namespace
}  // namespace kaori
