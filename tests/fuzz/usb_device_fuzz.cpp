// The USB machine of the control surfaces before a host that does as it likes. Each step is a byte: its low three bits say
// what the bus does, and a SETUP, data or a report follow as bytes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "firmware/surface/dial_box.h"
#include "firmware/surface/usb_device.h"
#include "tests/firmware/proof/usb_host.h"
#include "tests/fuzz/check.h"

namespace {

using FuzzedBytes = std::span<const std::uint8_t>;

FuzzedBytes NextFuzzedBytes(FuzzedBytes& from, std::size_t bytes) {
  const FuzzedBytes next = from.first(std::min(bytes, from.size()));
  from = from.subspan(next.size());
  return next;
}

// What the bus does.
enum Step { kReset, kSetup, kFetch, kSend, kOutput, kPoll, kSleep, kTurn };

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  surface::DialBox box({}, nullptr);
  proof::Cable cable;
  surface::UsbDevice device({.vendor = wire::kDialBoxVendor,
                             .product = wire::kDialBoxProduct,
                             .name = "Dial and button box",
                             .report_descriptor = wire::kDialBoxDescriptor,
                             .takes_output = true},
                            box, cable);
  std::uint8_t lines = 0;
  for (FuzzedBytes left(data, size); !left.empty();) {
    const std::uint8_t step = NextFuzzedBytes(left, 1)[0];
    if (step % 8 == kReset) device.HandleReset();
    if (step % 8 == kSetup) {
      std::array<std::uint8_t, 8> setup{};
      std::ranges::copy(NextFuzzedBytes(left, setup.size()), setup.begin());
      device.HandleSetup(setup);
      fuzz::Promise(cable.armed_in || cable.armed_out || cable.stalled, "a SETUP has an answer");
    }
    if (step % 8 == kFetch && cable.armed_in) {
      cable.armed_in.reset();
      device.HandleControlSent();
    }
    if (step % 8 == kSend && cable.armed_out) {
      cable.armed_out = false;
      device.HandleControlReceived(NextFuzzedBytes(left, step / 8 * 3));
    }
    if (step % 8 == kOutput) device.HandleOutput(NextFuzzedBytes(left, step / 8));
    if (step % 8 == kPoll) {
      device.Poll();
      if (step / 8 % 2 == 0) cable.input.reset();
    }
    if (step % 8 == kSleep) step / 8 % 2 == 0 ? device.HandleSuspend() : device.HandleResume();
    if (step % 8 == kTurn)
      box.Look(lines = static_cast<std::uint8_t>(lines ^ 1U << step / 8 % 8)), box.Tick(lines);
    fuzz::Promise(cable.broken.empty(), cable.broken.c_str());
  }
  return 0;
}
