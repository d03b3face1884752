// Expressions from the last row: each is told apart from each other in a picture of 96 pixels, by brows, lids and mouth,
// on every face of flesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "render/face/composer.h"
#include "render/passes/painter.h"
#include "tests/look/feature_cast.h"
#include "tests/look/look_pack.h"
#include "tests/look/report.h"

namespace kaori {
namespace {

constexpr int kSide_px = 96;
// As near as on the sheets of expressions.
constexpr float kClose_m = 0.78F;

// Light on some pixels, and where: sums over a picture.
struct Blot {
  double area_px = 0;
  double x_px = 0, y_px = 0;
  double xx = 0, xy = 0, yy = 0;

  void Add(double weight, double x, double y) {
    area_px += weight;
    x_px += weight * x;
    y_px += weight * y;
    xx += weight * x * x;
    xy += weight * x * y;
    yy += weight * y * y;
  }
  double MeanX() const { return x_px / std::max(area_px, 1e-3); }
  double MeanY() const { return y_px / std::max(area_px, 1e-3); }
  double VarX() const { return std::max(xx / std::max(area_px, 1e-3) - MeanX() * MeanX(), 1e-3); }
  double VarY() const { return std::max(yy / std::max(area_px, 1e-3) - MeanY() * MeanY(), 1e-3); }
  // Of the line through it.
  double Slope_deg() const {
    const double cov = xy / std::max(area_px, 1e-3) - MeanX() * MeanY();
    return std::atan(cov / VarX()) * 180 / std::numbers::pi;
  }
  // As long as a bar of this spread is.
  double Width_px() const { return std::sqrt(12 * VarX()); }
};

// What is read of a face from afar. A number, and by how much it must differ to be seen.
struct Feature {
  double value = 0;
  double seen = 1;
};
using Part = std::vector<Feature>;
struct Read {
  std::string name;
  std::array<Part, 3> parts;  // Brows, lids, mouth.
};

// By how many of its just seen differences a part differs most.
double Apart(const Part& a, const Part& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, std::abs(a[i].value - b[i].value) / a[i].seen);
  return most;
}

// Two parts that differ are read, or one that differs by twice as much: 2 and more is apart.
double Apart(const Read& a, const Read& b) {
  std::array<double, 3> parts{};
  for (std::size_t i = 0; i < 3; ++i) parts[i] = Apart(a.parts[i], b.parts[i]);
  std::ranges::sort(parts, std::ranges::greater{});
  return std::max(parts[0], 2 * parts[1]);
}

class Reader {
 public:
  explicit Reader(const std::vector<std::uint8_t>& bytes) {
    for (int y = 0; y < kSide_px; ++y) {
      for (int x = 0; x < kSide_px; ++x) Sort(&bytes[static_cast<std::size_t>((y * kSide_px + x) * 4)], x, y);
    }
  }

  std::array<Part, 3> Parts() const {
    // Height at the place on the face, tilt and how much is seen: inner ends that rise plead, outer ones sneer.
    constexpr double kBrow_px = 0.8, kBrow_deg = 7, kLid_px2 = 9, kWide_px = 1.4, kLift_px = 0.6,
                     kOpen_px2 = 4;
    Part brows, lids;
    for (const std::size_t side : {0U, 1U}) {
      brows.push_back({brow_[side].MeanY(), kBrow_px});
      brows.push_back({brow_[side].Slope_deg(), kBrow_deg});
      lids.push_back({eye_[side].area_px, kLid_px2});
    }
    return {brows, lids,
            Part{{lips_.Width_px(), kWide_px},
                 {lips_.MeanX(), kWide_px},
                 {Lift(0), kLift_px},
                 {Lift(1), kLift_px},
                 {inside_.area_px, kOpen_px2},
                 {std::sqrt(lips_.VarY()), 0.5}}};
  }

 private:
  // Sides by the picture's halves. Pictures hold roots of light.
  void Sort(const std::uint8_t* pixel, int x, int y) {
    const auto light = [&](int c) { return pixel[c] * pixel[c] / (255.0 * 255.0); };
    const double red = light(0);
    const double green = light(1);
    const double blue = light(2);
    const std::size_t side = x < kSide_px / 2 ? 0 : 1;
    eye_[side].Add(std::min({red, green, blue}), x, y);
    brow_[side].Add(std::max(red - std::max(green, blue), 0.0), x, y);
    const double lip = std::max(green - std::max(red, blue), 0.0);
    lips_.Add(lip, x, y);
    columns_[static_cast<std::size_t>(x)].Add(lip, x, y);
    inside_.Add(std::max(blue - std::max(red, green), 0.0), x, y);
  }

  // How far a corner of the mouth lies over its middle.
  double Lift(int side) const {
    Blot middle, end;
    const double half_px = lips_.Width_px() / 2;
    for (int x = 0; x < kSide_px; ++x) {
      const double off = (x - lips_.MeanX()) * (side == 0 ? -1 : 1) / half_px;
      const Blot& column = columns_[static_cast<std::size_t>(x)];
      Blot& into = std::abs(off) < 0.4 ? middle : end;
      if (std::abs(off) < 0.4 || off > 0.65) into.Add(column.area_px, x, column.MeanY());
    }
    return end.MeanY() - middle.MeanY();
  }

  std::array<Blot, 2> brow_, eye_;
  Blot lips_, inside_;
  std::array<Blot, kSide_px> columns_;
};

scene::Scene Wearing(std::uint16_t face, std::uint16_t expression) {
  scene::Scene scene;
  scene.weights.faces.Push(face, 1);
  scene.weights.expressions.Push(expression, 1);
  scene.camera.distance_m = kClose_m;
  scene.backdrop = {.top = {}, .bottom = {}};
  scene.styles = {};
  scene.styles[static_cast<std::size_t>(scene::Style::kHair)] = 1;
  return scene;
}

// All expressions of one face, as `painter` draws them.
std::vector<Read> ReadAll(const face::Cast& cast, std::uint16_t face, passes::Painter& painter,
                          const gl::Canvas& canvas) {
  std::vector<Read> all;
  std::vector<std::uint8_t> bytes(std::size_t{kSide_px} * kSide_px * 4);
  for (std::uint16_t e = 0; e < cast.expressions.size(); ++e) {
    if (cast.expressions[e].kind != face::ExpressionKind::kExpression) continue;
    painter.Draw(Wearing(face, e), canvas);
    canvas.ReadPixels(bytes);
    all.push_back({cast.expressions[e].name, Reader(bytes).Parts()});
  }
  return all;
}

// Pairs with one of these are alike at first sight, so more is asked of them.
bool IsAlike(const std::string& name) {
  constexpr std::array kAlike{"proud", "shy", "suspicious", "perplexed", "bored"};
  return std::ranges::find(kAlike, name) != kAlike.end();
}

// How many pairs of these are not told apart; each is a failure.
int CountConfused(const std::string& face, const std::vector<Read>& all) {
  int confused = 0;
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      const double apart = Apart(all[a], all[b]);
      const double asked = IsAlike(all[a].name) || IsAlike(all[b].name) ? 2.5 : 2.0;
      EXPECT_GE(apart, asked) << fmt::format(
          "{}, {} and {}: brows {:.1f}, lids {:.1f}, mouth {:.1f}", face, all[a].name, all[b].name,
          Apart(all[a].parts[0], all[b].parts[0]), Apart(all[a].parts[1], all[b].parts[1]),
          Apart(all[a].parts[2], all[b].parts[2]));
      if (apart < asked) ++confused;
    }
  }
  return confused;
}

// Of everybody with a face of flesh: a mask, a kettle and a robot have no cheeks, and a dog smiles with its muzzle.
constexpr std::array<std::string_view, 6> kPeople{"kaori",     "round",    "child",
                                                  "old_woman", "narrator", "poster"};

TEST(Expressions, AreToldApartFromTheLastRowOnEveryFaceOfFlesh) {
  const face::Cast cast = tests::FeatureCast(kPeople);
  auto context = gl::Context::Open();
  ASSERT_TRUE(context) << context.error().message();
  auto painter = passes::Painter::Open(**context, cast);
  ASSERT_TRUE(painter) << painter.error().message();
  const auto canvas = gl::Canvas::Make({.width_px = kSide_px, .height_px = kSide_px});
  ASSERT_TRUE(canvas) << canvas.error().message();
  int confused = 0;
  for (const std::string_view name : kPeople) {
    const auto face = std::ranges::find(cast.faces, name, &face::Face::name);
    ASSERT_NE(face, cast.faces.end()) << name;
    const auto all = ReadAll(cast, static_cast<std::uint16_t>(face - cast.faces.begin()), **painter, *canvas);
    ASSERT_EQ(all.size(), 24U);
    confused += CountConfused(face->name, all);
  }
  tests::Report("expressions_confused", confused);
}

// How far a place of the unrolled face rises with an expression on this face, millimetres.
double Rise_mm(const face::Cast& cast, std::uint16_t face, std::string_view point,
               std::string_view expression) {
  const auto named = [&](std::string_view name) {
    const auto found = std::ranges::find(cast.expressions, name, &face::Expression::name);
    return static_cast<std::uint16_t>(found - cast.expressions.begin());
  };
  const auto at = std::ranges::find(cast.net.points, point, &face::ControlPoint::name);
  if (at == cast.net.points.end()) return 0;
  face::Index nearest = 0;
  for (face::Index v = 0; v < cast.topology.moving_count; ++v) {
    if (glm::distance(cast.topology.uv[v], at->uv) < glm::distance(cast.topology.uv[nearest], at->uv))
      nearest = v;
  }
  face::Composer composer(cast);
  const auto height_m = [&](std::uint16_t worn) {
    face::Weights weights;
    weights.faces.Push(face, 1);
    weights.expressions.Push(worn, 1);
    return composer.Compose(weights, face::Detail::kCage).cage[nearest].y;
  };
  return 1000 * (height_m(named(expression)) - height_m(0));
}

TEST(Smile, TakesCheeksAndLowerLidsOfAllPeopleAlong) {
  const face::Cast cast = tests::ClothedCast();
  double cheek_mm = 1000, lid_mm = 1000;
  for (std::uint16_t face = 0; face < cast.faces.size(); ++face) {
    const std::string& name = cast.faces[face].name;
    if (std::ranges::find(kPeople, name) == kPeople.end()) continue;
    const double its_cheek_mm = Rise_mm(cast, face, "K1.l", "smile"),
                 its_lid_mm = Rise_mm(cast, face, "L2.l", "smile");
    EXPECT_GE(its_cheek_mm, 2.5) << name;
    EXPECT_GE(its_lid_mm, 1.5) << name;
    cheek_mm = std::min(cheek_mm, its_cheek_mm);
    lid_mm = std::min(lid_mm, its_lid_mm);
  }
  tests::Report("smile_cheek_rise_mm", cheek_mm);
  tests::Report("smile_lower_lid_rise_mm", lid_mm);
}

}  // namespace
}  // namespace kaori
