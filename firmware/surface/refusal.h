// A surface whose chip is too old for its firmware: it plays nothing, and says so in every way that it has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/surface/hid_function.h"
#include "firmware/surface/service.h"
#include "firmware/surface/usb_descriptors.h"

namespace kaori::surface {

// Stands in the place of DialBox or StickPod. Its feature report says kRefuses and the chip's stepping; there is
// no input report and no update, since no other image would make the chip younger. kRestart works, so that an
// image which was only tried on such a chip can be given up. One side.
class Refusal final : public HidFunction {
 public:
  // How often a second a board calls Tick.
  static constexpr std::uint32_t kTicksPerSecond = 4'000;

  explicit Refusal(const Unit& unit) : service_(unit, nullptr) {}

  // Which lamps' outputs are on during the next tick, with or without a host: the odd and the even ones in turn,
  // half a second each. No show lights lamps so, and the lamp test is another picture. A stick pod has no lamps.
  std::uint32_t Tick();

  bool wants_restart() const { return service_.wants_restart(); }

  // HidFunction.
  std::size_t Answer(ReportKind kind, std::span<std::uint8_t> into) override;
  bool Accept(ReportKind kind, std::span<const std::uint8_t> report) override;
  std::size_t NextInput(std::span<std::uint8_t>) override { return 0; }
  void SetHost(Host) override {}

 private:
  Service service_;
  Lamps lamps_;  // What asks for their brightness is not refused.
  std::uint32_t tick_ = 0;
};

// Who such a surface says it is: vendor, product and serial number stay, so that kaori-surface finds it; the name
// is a sentence for whoever reads the list of USB devices, and the report descriptor is no player's.
UsbIdentity RefusedIdentity(const UsbIdentity& identity);

}  // namespace kaori::surface
