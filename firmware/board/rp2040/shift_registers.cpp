#include "firmware/board/rp2040/shift_registers.h"

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/pins.h"
#include "firmware/board/rp2040/registers.h"

namespace kaori::rp2040 {
namespace {

constexpr std::uint32_t kBytesOf8Bits = 7;  // Motorola's format, clock low at rest, taken at the first edge.
constexpr std::uint32_t kEnable = 1U << 1;
// 125 MHz / 16 = 7.8 MHz: four bytes take about 4 us, far less than a tick of 250 us.
constexpr std::uint32_t kPrescale = 16;
// The status register's RNE bit: a byte has come that was not read (RP2040 datasheet, 4.4.4).
constexpr std::uint32_t kHasData = 1U << 2;
// 32 lamps out and 32 switches in; where fewer registers hang on the line, the first bits that come are
// theirs.
constexpr unsigned kBytes = 4;
constexpr std::uint32_t kStrobe = 1U << kShiftStrobePin;

}  // namespace

// The strobe's pin is an output already, by the table in pins.h.
void ShiftRegisters::Start() {
  Release(kResetSpi0);
  At(kSpi0 + kSpiPrescale) = kPrescale;
  At(kSpi0 + kSpiControl0) = kBytesOf8Bits;
  At(kSpi0 + kSpiControl1) = kEnable;
}

// One pulse of the strobe takes the switches into the 74HC165s and shows what the 74HC595s were sent last
// time; then 32 bits go each way at once. The lamps are therefore one exchange late, 0.25 ms.
std::uint32_t ShiftRegisters::Exchange(std::uint32_t lamps) {
  // A 74HC165 wants 24 ns at 3 V; each store takes 8 ns, and the registers of the pins answer at once.
  for (int n = 0; n < 8; ++n) At(kPinsClear) = kStrobe;
  At(kPinsSet) = kStrobe;
  // The register that is farthest from the chip's output comes first, its highest bit first of all.
  for (unsigned n = 0; n < kBytes; ++n) At(kSpi0 + kSpiData) = lamps >> (8 * (kBytes - 1 - n)) & 0xFFU;
  std::uint32_t open = 0;
  for (unsigned n = 0; n < kBytes; ++n) {
    while ((At(kSpi0 + kSpiStatus) & kHasData) == 0) {
    }
    open = open << 8 | (At(kSpi0 + kSpiData) & 0xFFU);
  }
  return ~open;  // A closed switch pulls its line to ground.
}

}  // namespace kaori::rp2040
