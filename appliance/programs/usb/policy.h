// Which USB devices the box authorises, by all that they offer together. docs/image.md tells it to people.
#pragma once

#include <optional>
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
};

// Why the device at `port` ("1-2.1", the kernel's name) stays unauthorised; nothing: it is authorised. It is,
// where
//   the service key is on, and it offers storage and nothing else
//   it names one of the makers of serial adapters of old dial boxes, and offers its maker's own class alone
//   it offers input, sound, hubs and cameras alone; in a kiosk no keyboard (protocol 1 of a boot interface)
// Whoever it says it is, one interface without a role keeps all of it out. `offer` may be the error of
// ReadUsbOffer, or of reading the file: then it stays out. Pure.
std::optional<store::RefusedUsb> WhyRefused(const Result<decode::UsbOffer>& offer, std::string_view port,
                                            const Situation& situation);

}  // namespace kaori::usb
