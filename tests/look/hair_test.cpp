// Hair while faces cross-fade, over all pairs: none of it hangs in the air, and none stands off the head like a horn.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>

#include "tests/look/morph_pictures.h"
#include "tests/look/report.h"

namespace kaori {
namespace {

using tests::Morph;
using tests::MorphPictures;
using tests::Pixels;

constexpr std::array<float, 5> kShares{0.1F, 0.25F, 0.5F, 0.75F, 0.9F};

// All but the largest region of what is drawn.
int Afloat_px(const Pixels& figure) {
  const auto regions = tests::RegionsOf(figure, MorphPictures::kWidth_px);
  const std::size_t largest_px = regions.empty() ? 0 : regions.front().size_px;
  return static_cast<int>(static_cast<std::size_t>(std::ranges::count(figure, true)) - largest_px);
}

// What belongs to one of the two sets alone.
int Differ_px(const Pixels& a, const Pixels& b) {
  int differ_px = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differ_px += a[i] != b[i] ? 1 : 0;
  return differ_px;
}

// What is seen of a morph.
struct Looks {
  Pixels figure;
  int afloat_px = 0;
  // How far hair, and what is worn with it, stands off the head.
  int off_px = 0;
};

class Hair : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    pictures_ = std::make_unique<MorphPictures>();
    for (std::uint16_t face = 0; face < pictures_->cast().faces.size(); ++face)
      alone_.push_back(Look({face, face, 0}));
  }
  static void TearDownTestSuite() {
    alone_.clear();
    pictures_.reset();
  }

  static Looks Look(const Morph& morph) {
    Looks seen{.figure = pictures_->Figure(morph)};
    seen.afloat_px = Afloat_px(seen.figure);
    seen.off_px = tests::FarthestFrom_px(seen.figure, pictures_->Bald(morph), MorphPictures::kWidth_px);
    return seen;
  }

  // Calls `visit` with every morph, and what is seen of it.
  template <class Visit>
  static void ForMorphs(const Visit& visit) {
    for (std::uint16_t from = 0; from < alone_.size(); ++from)
      for (std::uint16_t to = from + 1; to < alone_.size(); ++to)
        for (const float share : kShares) visit(Morph{from, to, share}, Look({from, to, share}));
  }
  static std::string NameOf(const Morph& morph) {
    const auto& faces = pictures_->cast().faces;
    return fmt::format("{} to {} at {}", faces[morph.from].name, faces[morph.to].name, morph.share);
  }

  static std::unique_ptr<MorphPictures> pictures_;
  // Each face by itself.
  static std::vector<Looks> alone_;
};
std::unique_ptr<MorphPictures> Hair::pictures_;
std::vector<Looks> Hair::alone_;

// A strand of some pixels; a tuft, or a head without its body, has a hundred.
constexpr int kStrand_px = 16;
// Farther than that of either head.
constexpr float kStandsUp_px = 5;
// Two heads of one outline, such as Kaori and her poster, in parts of the figure.
constexpr int kOneOutline = 50;

TEST_F(Hair, KeepsToTheHeadsThatItIsSharedBy) {
  int afloat_px = 0;
  float horn_px = 0;
  int one_outline = 0;
  ForMorphs([&](const Morph& morph, const Looks& seen) {
    const Looks& from = alone_[morph.from];
    const Looks& to = alone_[morph.to];
    EXPECT_LE(seen.afloat_px, kStrand_px) << NameOf(morph) << ": it hangs in the air";
    afloat_px = std::max(afloat_px, seen.afloat_px);
    const float off_px = static_cast<float>(std::max(from.off_px, to.off_px));
    const float farther_px = static_cast<float>(seen.off_px) - off_px;
    EXPECT_LE(farther_px, kStandsUp_px) << NameOf(morph) << ": it stands off the head";
    horn_px = std::max(horn_px, farther_px);
    const auto figure_px = static_cast<int>(std::ranges::count(from.figure, true));
    if (Differ_px(from.figure, to.figure) > figure_px / kOneOutline) return;
    ++one_outline;
    EXPECT_LE(Differ_px(seen.figure, from.figure), figure_px / kOneOutline)
        << NameOf(morph) << ": it is shaved";
  });
  EXPECT_GT(one_outline, 0) << "no two heads have one outline";
  tests::Report("morph_hair_afloat_px", afloat_px);
  tests::Report("morph_hair_horn_px", horn_px);
}

}  // namespace
}  // namespace kaori
