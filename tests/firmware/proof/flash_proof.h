// What must hold of the flash when the power goes at any moment.
#pragma once

#include <cstdint>

namespace kaori::proof {

struct FlashProof {
  std::uint64_t cuts = 0;
  std::uint64_t dead = 0;  // Nothing whole is started, or what is started takes no update any more.
  std::uint64_t unexpected =
      0;  // It starts an image that was never confirmed after the confirmed one came back, or older ones.
  std::uint64_t lost = 0;  // What was stored is neither the old nor the new bytes.
};
// Updates that must not be taken, or not stay: a wrong hash, data out of order, a second image while the first is only tried, an
// image that nobody confirms. Returns how often one was, or left a surface without the image that it had.
std::uint64_t ProveTrials(std::uint32_t rounds);

// Flips single bits of images, headers and stored bytes by chance: what is damaged is not used. Returns how often it was.
std::uint64_t ProveDefects(std::uint32_t flips);

// Plays two updates with confirmation and a stored calibration, with the power cut at each of their operations in three ways,
// and then starts, stores and updates once more. Other images and other halves for each round.
FlashProof ProveCuts(std::uint32_t rounds);

}  // namespace kaori::proof
