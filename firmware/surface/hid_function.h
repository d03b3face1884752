// What a device does beyond USB's own business: its reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kaori::surface {

// The numbers of GET_REPORT and SET_REPORT (HID 1.11, 7.2.1).
enum class ReportKind : std::uint8_t { kInput = 1, kOutput = 2, kFeature = 3 };

// Where the host is: gone (not plugged in, or has not configured the device), asleep (the bus is suspended),
// or there.
enum class Host : std::uint8_t { kGone, kAsleep, kThere };

// The longest report of a surface, and the packet of every endpoint.
inline constexpr std::size_t kPacketBytes = 64;

// Reports have no ids. One side: the one that drives the USB device.
class HidFunction {
 public:
  // Puts the report of this kind into `into`, which has kPacketBytes. Returns its length; 0: there is none.
  virtual std::size_t Answer(ReportKind kind, std::span<std::uint8_t> into) = 0;
  // An output or a feature report. False: refused.
  virtual bool Accept(ReportKind kind, std::span<const std::uint8_t> report) = 0;
  // The next input report, where something changed; it counts as told. Returns its length; 0: nothing
  // changed.
  virtual std::size_t NextInput(std::span<std::uint8_t> into) = 0;
  // A host that was gone and comes knows nothing.
  virtual void SetHost(Host host) = 0;

 protected:
  // Nobody owns one by this type.
  ~HidFunction() = default;
};

}  // namespace kaori::surface
