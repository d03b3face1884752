// A NOR flash whose power can be cut in the middle of any operation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "firmware/surface/flash.h"
#include "tests/firmware/proof/ideal_hand.h"

namespace kaori::proof {

// How much of the operation is done when the power goes. kHalf: bytes of it by chance, and of one byte some bits.
enum class Cut : std::uint8_t { kBefore, kHalf, kAfter };

class Nor final : public surface::Flash {
 public:
  // Whoever begins with what a chip is delivered with.
  Nor() : bytes_(surface::kStoreAt + 2 * surface::kSectorBytes, 0xFF) {}

  // The power goes at operation `number`, 1 the next one, and stays away: later ones do nothing.
  void CutAt(std::uint32_t number, Cut how, std::uint32_t seed) {
    left_ = number;
    how_ = how;
    dice_ = Dice(seed);
  }
  void PowerOn() {
    left_ = kNever;
    on_ = true;
  }
  bool is_on() const { return on_; }
  std::uint32_t operations() const { return operations_; }
  // A bit that flips by itself.
  void Flip(std::uint32_t at, std::uint8_t mask) { bytes_[at] ^= mask; }

  std::span<const std::uint8_t> Read(std::uint32_t at, std::size_t bytes) const override {
    return std::span(bytes_).subspan(at, bytes);
  }
  void Erase(std::uint32_t at) override {
    faults_ += at % surface::kSectorBytes != 0;
    Do([&](std::uint32_t n) { bytes_[at + n] = 0xFF; }, surface::kSectorBytes);
  }
  void Program(std::uint32_t at, std::span<const std::uint8_t> bytes) override {
    faults_ += at % surface::kPageBytes != 0 || bytes.size() > surface::kPageBytes;
    Do([&](std::uint32_t n) { bytes_[at + n] &= bytes[n]; }, static_cast<std::uint32_t>(bytes.size()),
       [&](std::uint32_t n) { bytes_[at + n] &= static_cast<std::uint8_t>(bytes[n] | dice_.Throw(256)); });
  }
  // Calls that no chip can do.
  std::uint32_t faults() const { return faults_; }

 private:
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

  template <class Step>
  void Do(Step step, std::uint32_t count) {
    Do(step, count, [](std::uint32_t) {});
  }
  template <class Step, class Partly>
  void Do(Step step, std::uint32_t count, Partly partly) {
    if (!on_) return;
    ++operations_;
    if (left_ != kNever) --left_;
    const bool cut = left_ == 0;
    if (cut) on_ = false;
    if (cut && how_ == Cut::kBefore) return;
    for (std::uint32_t n = 0; n < count; ++n) {
      if (!cut || how_ == Cut::kAfter || dice_.OneIn(2)) {
        step(n);
      } else if (dice_.OneIn(4)) {
        partly(n);
      }
    }
  }

  std::vector<std::uint8_t> bytes_;
  bool on_ = true;
  std::uint32_t left_ = kNever;
  Cut how_ = Cut::kBefore;
  Dice dice_{1};
  std::uint32_t operations_ = 0;
  std::uint32_t faults_ = 0;
};

}  // namespace kaori::proof
