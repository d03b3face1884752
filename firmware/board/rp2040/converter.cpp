#include "firmware/board/rp2040/converter.h"

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/pins.h"
#include "firmware/board/rp2040/registers.h"

namespace kaori::rp2040 {
namespace {

constexpr std::uint32_t kBytesOf8Bits = 7;  // Motorola's format, clock low at rest, taken at the first edge.
constexpr std::uint32_t kEnable = 1U << 1;
constexpr std::uint32_t kPrescale = 126;  // 0.99 MHz, what it bears at 2.7 V.
// The status register's RNE bit: a byte has come that was not read (RP2040 datasheet, 4.4.4).
constexpr std::uint32_t kHasData = 1U << 2;
constexpr std::uint32_t kSelect = 1U << kConverterSelectPin;

}  // namespace

// The select line is high before the SPI is on: a converter that saw half a command would answer the next one
// wrong.
void Converter::Start() {
  Release(kResetSpi1);
  At(kPinsSet) = kSelect;
  At(kSpi1 + kSpiPrescale) = kPrescale;
  At(kSpi1 + kSpiControl0) = kBytesOf8Bits;
  At(kSpi1 + kSpiControl1) = kEnable;
}

// Five zeros, a start bit, single-ended, three bits of the channel; the code follows a null bit (MCP3208 data
// sheet, 6.1).
std::uint16_t Converter::Read(unsigned channel) {
  At(kPinsClear) = kSelect;
  At(kSpi1 + kSpiData) = 0x06U | channel >> 2;
  At(kSpi1 + kSpiData) = (channel & 3U) << 6;
  At(kSpi1 + kSpiData) = 0;
  std::uint32_t bits = 0;
  for (int n = 0; n < 3; ++n) {
    while ((At(kSpi1 + kSpiStatus) & kHasData) == 0) {
    }
    bits = bits << 8 | (At(kSpi1 + kSpiData) & 0xFFU);
  }
  At(kPinsSet) = kSelect;
  return static_cast<std::uint16_t>(bits & 0xFFFU);
}

}  // namespace kaori::rp2040
