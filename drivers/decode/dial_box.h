// Decodes a box of endless dials, buttons and lamps: reports to accumulated counts, lamps to a report.
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

// More dials or lamps of a device are ignored. The board has room for these (appliance/core/board).
inline constexpr std::size_t kMaxDials = 8;
inline constexpr std::size_t kMaxLamps = 32;

// The newest state of a dial box, as a value to copy. A dial has no position, only a sum of turns.
struct DialSample {
  Time at{};                                     // When the newest good report arrived.
  std::array<std::int32_t, kMaxDials> counts{};  // Accumulated; clockwise is positive; wraps at 32 bits.
  Switches<1> buttons;
};

// Pure: no file descriptor, no clock. One decoder belongs to one opened device; keep its sample
// over a re-plug to keep the counts, so that an expression does not jump when a cable is put back.
// Decode allocates nothing once a report of each id has come.
class DialBoxDecoder {
 public:
  // For any device that Recognise calls kDialBox. The counts go on from those of
  // `before`; its switches are up until the first report. Errors:
  //   invalid_argument  the report descriptor is broken
  //   not_supported     the device has no endless dial
  static Result<DialBoxDecoder> For(const ports::HidIdentity& identity, const DialSample& before = {});

  // The same for any device that has a dial or a button, whatever it is for: for surfaces that a person has
  // written a map for. Errors:
  //   invalid_argument  the report descriptor is broken
  //   not_supported     it has neither
  static Result<DialBoxDecoder> ForSurface(const ports::HidIdentity& identity);

  // Decodes one input report and returns the new sample. A dial that this report
  // does not have keeps its count. `report` begins with its id where the descriptor
  // has ids; `at` becomes the sample's time. Errors:
  //   bad_message  the report is torn, short, long or of an unknown id; the sample stays as it was
  Result<DialSample> Decode(std::span<const std::uint8_t> report, Time at);

  // To be called when the cable was pulled: buttons go up, counts
  // stay, and the next position of a wrapping dial counts as no turn.
  void Release();

  // The newest sample, also after Release.
  const DialSample& sample() const { return sample_; }
  // How many endless dials the device has, kMaxDials at most.
  std::size_t dials() const { return dials_.size(); }

  // The output report that switches on the lamps of `lit` (bit n: lamp n) and switches off the others,
  // report id first as HidChannel::Write expects it. Lamps are counted in the order of the descriptor,
  // over the fields of one report. Empty for a box without lamps.
  std::vector<std::uint8_t> LampReport(std::uint32_t lit) const;

 private:
  // Where the dial is in the reports, and what was read there last.
  struct Dial {
    // Which element of which field.
    ElementRef where;
    std::optional<std::int64_t> position;  // Of a wrapping dial, once seen.
  };
  // `layout` is that of a dial box.
  DialBoxDecoder(ReportLayout layout, const DialSample& before);
  // The turn of one dial since the last report, clockwise positive; remembers a wrapping dial's
  // position. The first position of a wrapping dial is no turn.
  std::int32_t Turned(Dial& dial, std::int64_t value) const;

  // Of the device's own descriptor.
  ReportLayout layout_;
  std::vector<Dial> dials_;
  // Of the Button page, from button 1.
  SwitchReader<1> buttons_;
  DialSample sample_;
};

}  // namespace kaori::decode
