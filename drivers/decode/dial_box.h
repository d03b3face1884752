// A box of endless dials, buttons and lamps: reports to accumulated values, lamps to a report.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/decode/report_values.h"
#include "drivers/decode/switches.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::decode {

inline constexpr std::size_t kMaxDials = 8;
inline constexpr std::size_t kMaxLamps = 32;

struct DialSample {
  Time at{};                                     // When the newest good report arrived.
  std::array<std::int32_t, kMaxDials> counts{};  // Accumulated; clockwise is positive; wraps at 32 bits.
  Switches<1> buttons;
};

// Pure: no descriptor, no clock. It outlives the device: keep it over a re-plug to keep the counts.
class DialBoxDecoder {
 public:
  // Any device with an endless dial (Recognise says kDialBox). `before` is where the counts go on from.
  // Errors: invalid_argument (the descriptor), not_supported (no endless dial).
  static Result<DialBoxDecoder> For(const ports::HidIdentity& identity, const DialSample& before = {});

  // Takes one input report. Errors: bad_message  torn, short, long or unknown; the sample stays as it was.
  Result<DialSample> Decode(std::span<const std::uint8_t> report, Time at);

  // The cable was pulled: buttons go up, counts stay, and the next position of a wrapping dial is a new
  // start.
  void Release();

  const DialSample& sample() const { return sample_; }
  std::size_t dials() const { return dials_.size(); }

  // The output report that lights the lamps of `lit` (bit n: lamp n), report id first as HidChannel::Write
  // takes it. Empty for a box without lamps.
  std::vector<std::uint8_t> LampReport(std::uint32_t lit) const;

 private:
  struct Dial {
    ElementRef where;
    std::optional<std::int64_t> position;  // Of a wrapping dial, once seen.
  };
  DialBoxDecoder(ReportLayout layout, const DialSample& before);
  std::int32_t Turned(Dial& dial, std::int64_t value) const;

  ReportLayout layout_;
  std::vector<Dial> dials_;
  SwitchReader<1> buttons_;
  DialSample sample_;
};

}  // namespace kaori::decode
