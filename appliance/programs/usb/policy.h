// Which USB devices the box authorises, by all that they offer together. docs/image.md tells it to people.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "appliance/core/store/refused_usb.h"
#include "drivers/decode/usb_offer.h"

namespace kaori::usb {

// What the policy depends on beside the device. The profile "bench" does not ask.
struct Situation {
  // The service key is on: a stick may bring a show.
  bool key_is_on = false;
  // Nobody types: no keyboards.
  bool is_kiosk = false;
  // Where the box's own bridge to GPIO lines is plugged in; empty: none has come yet.
  std::string own_bridge{};
  // The box's start is over: what comes now was not there when power came.
  bool has_started = false;
};

// A bridge to GPIO lines, of a number that the kernel has a driver for. The service key may hang at it.
bool IsLineBridge(const decode::UsbOffer& offer);

// Why the device at `port` ("1-2.1", the kernel's name) stays unauthorised; nothing: it is authorised. It is, where
//   the service key is on, and it offers storage and nothing else
//   it names one of the makers of serial adapters of old dial boxes, and offers its maker's own class alone
//   it is the box's bridge to GPIO lines: the first one of a start, and at its port ever after. Whoever brought another one
//   could turn the service key on by it
//   it offers input, sound, hubs and cameras alone; in a kiosk no keyboard (protocol 1 of a boot interface)
// Whoever it says it is, one interface without a role keeps all of it out. `offer` may be the error of
// ReadUsbOffer, or of reading the file: then it stays out. Pure.
std::optional<store::RefusedUsb> WhyRefused(const Result<decode::UsbOffer>& offer, std::string_view port,
                                            const Situation& situation);

}  // namespace kaori::usb
