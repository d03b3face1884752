// What kaori-usb says of a USB device that stays unauthorised: a file in memory, /run/kaori-usb/PORT, which the status picture
// and the support file read. It goes when the device is unplugged; of a device that was authorised it is empty.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kaori::store {

// How loudly it is said.
//   kQuiet  nobody brought it for the show, as a telephone that is charged: in the journal and the support file alone
//   kNamed  somebody may want it to work, as a stick without the service key: on the status picture too
//   kFault  it says that it is several things at once, or cannot be read: there too, as a fault
enum class Weight : std::uint8_t { kQuiet, kNamed, kFault };

// Both sentences name the port: "USB port 1-2: a storage device stays out while the service key is off".
struct RefusedUsb {
  Weight weight = Weight::kQuiet;
  // ASCII.
  std::string english;
  std::string japanese;

  friend bool operator==(const RefusedUsb&, const RefusedUsb&) = default;
};

// Three lines: the weight's word, the sentence in English, and in Japanese. Pure.
std::string FormatRefusedUsb(const RefusedUsb& refused);

// Nothing where the text is none, as that of a device which was authorised. Pure.
std::optional<RefusedUsb> ParseRefusedUsb(std::string_view text);

}  // namespace kaori::store
