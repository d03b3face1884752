#include "render/passes/pores.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kaori::passes {
namespace {

constexpr int kSide = 512;
// One pit in each cell of a grid.
constexpr int kCells = 64;
constexpr int kCell = kSide / kCells;
// How wide a pit is, texels; how deep the grain between pits is, of a pit's depth.
constexpr float kPitWidth = 2.1F;
constexpr float kGrain = 0.22F;
// From heights to codes: the steepest pit is near the end of the range.
constexpr float kSlopeToCode = 1.5F;

// A number in 0..1 that looks drawn by chance (Wellons' lowbias32 mixing).
float Chance(std::uint32_t x) {
  x ^= x >> 16U;
  x *= 0x7feb352dU;
  x ^= x >> 15U;
  x *= 0x846ca68bU;
  x ^= x >> 16U;
  return static_cast<float>(x >> 8U) / 16777216.0F;
}

std::size_t At(int x, int y) {
  const int wrapped_x = (x + kSide) % kSide;
  const int wrapped_y = (y + kSide) % kSide;
  return static_cast<std::size_t>(wrapped_y) * kSide + static_cast<std::size_t>(wrapped_x);
}

// Presses a round pit into the heights, over the edges as well.
void Press(std::vector<float>& heights, float x, float y, float depth) {
  constexpr int kReach = 6;
  const int middle_x = static_cast<int>(x);
  const int middle_y = static_cast<int>(y);
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const float away_x = static_cast<float>(middle_x + dx) - x;
      const float away_y = static_cast<float>(middle_y + dy) - y;
      heights[At(middle_x + dx, middle_y + dy)] -=
          depth * std::exp(-(away_x * away_x + away_y * away_y) / (kPitWidth * kPitWidth));
    }
  }
}

std::vector<float> Heights() {
  std::vector<float> heights(std::size_t{kSide} * kSide);
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = kGrain * (Chance(static_cast<std::uint32_t>(i)) - 0.5F);
  for (int cell_y = 0; cell_y < kCells; ++cell_y) {
    for (int cell_x = 0; cell_x < kCells; ++cell_x) {
      const auto cell = static_cast<std::uint32_t>(kSide * kSide + 3 * (cell_y * kCells + cell_x));
      const float x = (static_cast<float>(cell_x) + Chance(cell)) * kCell;
      const float y = (static_cast<float>(cell_y) + Chance(cell + 1)) * kCell;
      Press(heights, x, y, 0.4F + 0.6F * Chance(cell + 2));
    }
  }
  return heights;
}

std::byte Code(float slope) {
  return static_cast<std::byte>(
      std::lround(std::clamp(127.5F + 127.5F * kSlopeToCode * slope, 0.0F, 255.0F)));
}

}  // namespace

gl::Texture MakePores() {
  const std::vector<float> heights = Heights();
  std::vector<std::byte> pixels(heights.size() * 4);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::size_t at = At(x, y) * 4;
      pixels[at] = Code(0.5F * (heights[At(x - 1, y)] - heights[At(x + 1, y)]));
      pixels[at + 1] = Code(0.5F * (heights[At(x, y - 1)] - heights[At(x, y + 1)]));
    }
  }
  const auto levels = gl::MipLevelsOf(std::move(pixels), kSide, kSide);
  return gl::Texture({.width_px = kSide, .height_px = kSide, .mipmaps = true, .repeats = true}, levels);
}

}  // namespace kaori::passes
