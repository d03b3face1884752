// A, I, U, E, O from an operator's painted lips to the drawn face: can they be read there?
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "hw-sim/rehearsal/rehearsal.h"
#include "hw-sim/scenario/speech.h"

namespace kaori {
namespace {

constexpr std::string_view kVowels = "aiueo";
constexpr double kHz = 30;

using Vertices = std::vector<glm::vec3>;

// Vertices of the face that tell how the mouth stands.
struct Landmarks {
  std::size_t upper = 0, lower = 0;  // In the middle of the lips, touching while they are shut.
  std::size_t left = 0, right = 0;   // The corners.
};

struct DrawnMouth {
  double opening_mm = 0;
  double width_mm = 0;
};

DrawnMouth Measure(const Vertices& face, const Landmarks& at) {
  return {1e3 * static_cast<double>(face[at.upper].y - face[at.lower].y),
          1e3 * static_cast<double>(face[at.left].x - face[at.right].x)};
}

// The lower lip is what an A moves down most, the upper one what touched it and stayed behind; the corners
// are what an I takes farthest out and a U farthest in.
Landmarks FindLandmarks(const face::Topology& topology, const Vertices& shut,
                        const std::array<Vertices, 5>& said) {
  constexpr float kMiddle_m = 0.004F;
  Landmarks at;
  float most_down = 0;
  float most_left = 0;
  float most_right = 0;
  for (std::size_t n = 0; n < topology.moving_count; ++n) {
    if (topology.mouth_share[n] < 0.5F) continue;
    const float down = shut[n].y - said[0][n].y;
    if (std::abs(shut[n].x) < kMiddle_m && down > most_down) most_down = down, at.lower = n;
    const float out = said[1][n].x - said[2][n].x;
    if (out > most_left) most_left = out, at.left = n;
    if (out < most_right) most_right = out, at.right = n;
  }
  float nearest = 1;
  for (std::size_t n = 0; n < topology.moving_count; ++n) {
    if (topology.mouth_share[n] < 0.5F || std::abs(shut[n].x) > kMiddle_m) continue;
    const float away = glm::distance(shut[n], shut[at.lower]);
    if (shut[n].y - said[0][n].y > 0.3F * most_down || away >= nearest) continue;
    nearest = away;
    at.upper = n;
  }
  return at;
}

class Vowels : public ::testing::Test {
 protected:
  Vowels() : folder_(std::filesystem::temp_directory_path() / fmt::format("kaori-vowels-{}", ::getpid())) {}
  ~Vowels() override { std::filesystem::remove_all(folder_); }

  void SetUp() override {
    auto show = show::LoadPack(KAORI_PACK);
    ASSERT_TRUE(show) << show.error().message();
    auto studio = stage::Studio::Open(std::move(*show));
    ASSERT_TRUE(studio) << studio.error().message();
    studio_ = std::move(*studio);
    auto rehearsal =
        sim::Rehearsal::Open({.folder = folder_, .width_px = 320, .height_px = 180, .hz = kHz}, *studio_);
    ASSERT_TRUE(rehearsal) << rehearsal.error().message();
    rehearsal_ = std::move(*rehearsal);
    rehearsal_->rig().dial_box().Turn(6, -1);  // Life off: only the lips move her.
    rehearsal_->rig().dial_box().Push(0);
    Play(0.2);
    rehearsal_->rig().dial_box().Release(0);
    Play(1.5);  // She is there, and her operator's mouth at rest is known.
  }

  void Play(double seconds) {
    for (int n = 0; n < static_cast<int>(seconds * kHz); ++n) {
      const auto shown = rehearsal_->NextPicture();
      ASSERT_TRUE(shown) << shown.error().message();
      shown_ = *shown;
    }
  }

  Vertices Drawn() const {
    const auto& cage = studio_->shape().cage;
    return {cage.begin(), cage.end()};
  }

  // With KAORI_PICTURES set: the picture that the audience sees.
  void Keep(char vowel) const {
    const char* folder = std::getenv("KAORI_PICTURES");
    if (folder == nullptr) return;
    std::ofstream out(fmt::format("{}/{}.ppm", folder, vowel), std::ios::binary);
    out << "P6\n" << shown_.width_px << ' ' << shown_.height_px << "\n255\n";
    for (int y = shown_.height_px - 1; y >= 0; --y)
      for (int x = 0; x < shown_.width_px; ++x) {
        const auto at = static_cast<std::size_t>(y * shown_.width_px + x) * 4;
        out.write(reinterpret_cast<const char*>(&shown_.rgbx[at]), 3);
      }
  }

  // The mouth that an operator makes for a vowel.
  static sim::Mouth MouthOf(char vowel) {
    const auto actions = sim::Speak(std::string(1, vowel), {}, std::chrono::seconds(1));
    return {actions.front().action.a, actions.front().action.b};
  }

  std::filesystem::path folder_;
  std::unique_ptr<stage::Studio> studio_;
  std::unique_ptr<sim::Rehearsal> rehearsal_;
  sim::Shown shown_;
};

TEST_F(Vowels, AreToldApartByOpeningAndWidthOnTheDrawnFace) {
  const Vertices shut = Drawn();
  std::array<Vertices, 5> said;
  for (std::size_t n = 0; n < kVowels.size(); ++n) {
    const sim::Mouth mouth = MouthOf(kVowels[n]);
    rehearsal_->rig().camera().SetMouth(mouth.height, mouth.width);
    Play(0.5);
    said[n] = Drawn();
    Keep(kVowels[n]);
  }
  const Landmarks at = FindLandmarks(studio_->show().cast.topology, shut, said);
  std::array<DrawnMouth, 5> drawn;
  for (std::size_t n = 0; n < said.size(); ++n) {
    drawn[n] = Measure(said[n], at);
    fmt::print("{}: {:5.1f} mm open, {:5.1f} mm wide\n", kVowels[n], drawn[n].opening_mm, drawn[n].width_mm);
  }
  fmt::print("rest: {:.1f} mm open, {:.1f} mm wide\n", Measure(shut, at).opening_mm,
             Measure(shut, at).width_mm);
  const auto& [a, i, u, e, o] = drawn;
  EXPECT_GT(a.opening_mm, o.opening_mm + 2) << "a is the most open,";
  EXPECT_GT(o.opening_mm, e.opening_mm + 0.8);
  EXPECT_GT(e.opening_mm, i.opening_mm + 2);
  EXPECT_GE(i.opening_mm, u.opening_mm - 0.5) << "and i and u the least.";
  EXPECT_GT(i.width_mm, e.width_mm + 1) << "i is the widest,";
  EXPECT_GT(e.width_mm, o.width_mm + 4);
  EXPECT_GT(o.width_mm, u.width_mm + 1) << "and u the narrowest.";
  for (std::size_t n = 0; n < drawn.size(); ++n)
    for (std::size_t k = 0; k < n; ++k)
      EXPECT_GT(std::hypot(drawn[n].opening_mm - drawn[k].opening_mm, drawn[n].width_mm - drawn[k].width_mm),
                3)
          << kVowels[n] << " and " << kVowels[k] << " look the same";
}

}  // namespace
}  // namespace kaori
