#include "tests/hil/agent/damage.h"

#include <algorithm>
#include <random>

namespace kaori::agent {
namespace {

constexpr std::size_t kSector_bytes = 512;
constexpr std::size_t kMostRun_bytes = 64;
constexpr int kMostDamages_log2 = 4;

// One image's chances. The engine's numbers are the same everywhere, those of std's distributions are not.
class Chance {
 public:
  explicit Chance(std::uint64_t number) : engine_(number) {}
  // 0 to `count` - 1; `count` is above 0.
  std::size_t Below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  std::uint8_t Byte() { return static_cast<std::uint8_t>(engine_()); }

 private:
  std::mt19937_64 engine_;
};

// A sector that lies whole within the image; the image has one at least.
std::span<std::uint8_t> Sector(std::span<std::uint8_t> image, std::size_t at) {
  return image.subspan(std::min(at / kSector_bytes, image.size() / kSector_bytes - 1) * kSector_bytes,
                       kSector_bytes);
}

// What happens to bytes that lie in a row.
void DamageRun(std::span<std::uint8_t> run, Chance& chance) {
  const std::size_t how = chance.Below(3);
  for (std::uint8_t& byte : run)
    byte = how == 0 ? std::uint8_t{0} : how == 1 ? std::uint8_t{0xFF} : chance.Byte();
}

void DamageOnce(std::span<std::uint8_t> image, std::size_t described_bytes, Chance& chance) {
  const std::size_t within = chance.Below(4) == 0 ? image.size() : described_bytes;
  const std::size_t at = chance.Below(within);
  const auto run = image.subspan(at, std::min(1 + chance.Below(kMostRun_bytes), image.size() - at));
  switch (chance.Below(16)) {
    case 0:
    case 1:
    case 2:
      return DamageRun(run, chance);
    case 3:
      std::ranges::swap_ranges(Sector(image, at), Sector(image, chance.Below(within)));
      return;
    case 4:
      std::ranges::copy(Sector(image, chance.Below(within)), Sector(image, at).begin());
      return;
    case 5:  // As of a stick that was pulled while it was written, in one of four.
      if (chance.Below(4) == 0) std::ranges::fill(image.subspan(at), std::uint8_t{0});
      return;
    case 6:
    case 7:
    case 8:
    case 9:
      image[at] = chance.Byte();
      return;
    default:
      image[at] = static_cast<std::uint8_t>(image[at] ^ (1U << chance.Below(8)));
  }
}

}  // namespace

// As often one or two damages as nine to sixteen: a single one reaches further into a driver.
void Damage(std::span<std::uint8_t> image, std::size_t described_bytes, std::uint64_t number) {
  if (image.size() < kSector_bytes || described_bytes == 0) return;
  Chance chance(number);
  const std::size_t most = std::size_t{1} << chance.Below(kMostDamages_log2 + 1);
  const std::size_t damages = 1 + chance.Below(most);
  for (std::size_t n = 0; n < damages; ++n)
    DamageOnce(image, std::min(described_bytes, image.size()), chance);
}

}  // namespace kaori::agent
