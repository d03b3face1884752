#include "appliance/programs/usb/policy.h"

#include <algorithm>
#include <array>
#include <string>

#include "appliance/programs/usb/kind_names.h"

namespace kaori::usb {
namespace {

using decode::OfferedInterface;
using decode::UsbClass;
using decode::UsbOffer;
using store::RefusedUsb;
using store::Weight;

// Their chips are in the serial adapters of old dial boxes: FTDI, Prolific, CH340.
constexpr std::array<std::uint16_t, 3> kSerialMakers{0x0403, 0x067B, 0x1A86};

bool IsOfSerialMaker(const UsbOffer& offer) {
  return std::ranges::find(kSerialMakers, offer.vendor) != kSerialMakers.end();
}

constexpr std::uint16_t kMicrochip = 0x04D8, kMcp2221a = 0x00DD, kSiliconLabs = 0x10C4, kCp2112 = 0xEA90;

bool IsMcp2221a(const UsbOffer& offer) {
  return offer.vendor == kMicrochip && offer.product == kMcp2221a;
}

// Microchip's bridge of USB to GPIO lines, which is a serial port (its datasheet, DS20005565, 1.4) besides: the box has no
// driver for that, and lets it be. Networks call themselves communication too, of another subclass or protocol.
bool IsHonestMcp2221a(const UsbOffer& offer) {
  constexpr std::uint8_t kModem = 2, kCommands = 1;
  const auto is_its_own = [](const OfferedInterface& one) {
    const bool serial =
        one.kind == UsbClass::kCommunication && one.subclass == kModem && one.protocol == kCommands;
    return serial || one.kind == UsbClass::kData || one.kind == UsbClass::kInput;
  };
  return IsMcp2221a(offer) && std::ranges::all_of(offer.interfaces, is_its_own) &&
         std::ranges::none_of(offer.interfaces, IsKeyboard);
}

bool OffersOnly(const UsbOffer& offer, UsbClass kind) {
  return std::ranges::all_of(offer.interfaces, [kind](const auto& one) { return one.kind == kind; });
}

// In every profile, and by itself.
bool HasRole(const OfferedInterface& one) {
  constexpr std::array kRoles{UsbClass::kSound, UsbClass::kInput, UsbClass::kHub, UsbClass::kCamera};
  return std::ranges::find(kRoles, one.kind) != kRoles.end();
}

bool IsOwnBridge(std::string_view port, const Situation& situation) {
  return situation.own_bridge.empty() ? !situation.has_started : situation.own_bridge == port;
}

// The policy: each line is one way to be authorised or refused, and the words further down only tell of it.
bool IsAuthorised(const UsbOffer& offer, std::string_view port, const Situation& situation) {
  if (IsLineBridge(offer) && !IsOwnBridge(port, situation)) return false;
  if (situation.key_is_on && OffersOnly(offer, UsbClass::kStorage)) return true;
  if (IsOfSerialMaker(offer) && OffersOnly(offer, UsbClass::kVendor)) return true;
  if (IsHonestMcp2221a(offer)) return true;
  if (!std::ranges::all_of(offer.interfaces, HasRole)) return false;
  return !situation.is_kiosk || std::ranges::none_of(offer.interfaces, IsKeyboard);
}

// What somebody may have brought for the show: it has a role, or would have one alone.
bool IsWanted(const OfferedInterface& one, bool of_serial_maker) {
  return HasRole(one) || one.kind == UsbClass::kStorage || (of_serial_maker && one.kind == UsbClass::kVendor);
}

// The first interface for which it holds; nothing where there is none.
template <class Holds>
const OfferedInterface* FirstOf(const UsbOffer& offer, Holds holds) {
  const auto found = std::ranges::find_if(offer.interfaces, holds);
  return found == offer.interfaces.end() ? nullptr : &*found;
}

// Both sentences begin with the port, so that a person finds the socket whichever of them is read.
RefusedUsb Say(Weight weight, std::string_view port, const std::string& english,
               const std::string& japanese) {
  return {.weight = weight,
          .english = "USB port " + std::string(port) + ": " + english,
          .japanese = "USBポート" + std::string(port) + ": " + japanese};
}

// A telephone that is charged offers pictures, and often sound besides: nobody is to be told of it in a show.
RefusedUsb SayUnwanted(std::string_view port, const KindName& name) {
  return Say(Weight::kQuiet, port, std::string(name.english) + " stays out, since the box has no role for it",
             std::string(name.japanese) + "はこの箱では使えません");
}

// Whoever carries the number of a maker of serial adapters and is none pretends, and somebody is to look at the port.
RefusedUsb SayPretender(std::string_view port, const KindName& name) {
  return Say(Weight::kFault, port,
             std::string(name.english) + " with the number of a serial adapter's maker stays out",
             "シリアル変換器の番号を名乗る" + std::string(name.japanese) + "は使えません");
}

// `without` has no role beside the rest, and `with` would have one alone.
RefusedUsb SayMixed(std::string_view port, const KindName& without, const KindName& with) {
  return Say(
      Weight::kFault, port,
      std::string(without.english) + " that also calls itself " + std::string(with.english) + " stays out",
      std::string(with.japanese) + "とも名乗る" + std::string(without.japanese) + "は使えません");
}

// Of one that was not there when the box started a person learns what to do; of a second one, where the first one is.
RefusedUsb SayOtherBridge(std::string_view port, const Situation& situation) {
  if (situation.own_bridge.empty())
    return Say(Weight::kFault, port,
               "a GPIO bridge that comes after the start stays out; switch the box on with it plugged in",
               "起動後に差されたGPIOブリッジは使えません。差したまま電源を入れてください");
  return Say(Weight::kFault, port,
             "a GPIO bridge stays out here, since the box's own is that of port " + situation.own_bridge,
             "この箱のGPIOブリッジはポート" + situation.own_bridge + "のものです。ここでは使えません");
}

}  // namespace

bool IsLineBridge(const UsbOffer& offer) {
  return IsMcp2221a(offer) || (offer.vendor == kSiliconLabs && offer.product == kCp2112);
}

// The words follow the first reason that holds; all of them are of our own, none is the device's.
std::optional<RefusedUsb> WhyRefused(const Result<UsbOffer>& offer, std::string_view port,
                                     const Situation& situation) {
  if (!offer)
    return Say(Weight::kFault, port,
               "a device whose descriptors cannot be read stays out (" + offer.error().message() + ")",
               "記述子を読めない機器は使えません");
  if (IsAuthorised(*offer, port, situation)) return std::nullopt;
  if (IsLineBridge(*offer) && !IsOwnBridge(port, situation)) return SayOtherBridge(port, situation);
  if (OffersOnly(*offer, UsbClass::kStorage))
    return Say(Weight::kNamed, port, "a storage device stays out while the service key is off",
               "記憶装置はサービスキーを入れるまで使えません");
  if (std::ranges::all_of(offer->interfaces, HasRole))
    return Say(Weight::kNamed, port, "a keyboard stays out, since this box is a kiosk",
               "キオスクの箱ではキーボードは使えません");
  const bool serial = IsOfSerialMaker(*offer);
  const auto name = [serial](const OfferedInterface* one) { return NameOf(*one, serial); };
  const auto is_wanted = [serial](const auto& one) { return IsWanted(one, serial); };
  const auto* const picture =
      FirstOf(*offer, [](const auto& one) { return one.kind == UsbClass::kStillImage; });
  if (picture != nullptr) return SayUnwanted(port, name(picture));
  const auto* const wanted = FirstOf(*offer, is_wanted);
  const auto* const unwanted = FirstOf(*offer, [&](const auto& one) { return !is_wanted(one); });
  if (wanted == nullptr)
    return serial ? SayPretender(port, name(unwanted)) : SayUnwanted(port, name(unwanted));
  if (unwanted != nullptr) return SayMixed(port, name(unwanted), name(wanted));
  // Each of them would have a role alone: what has it only by the key, or by its maker, is told of first.
  const auto* const guest = FirstOf(*offer, [](const auto& one) { return one.kind == UsbClass::kStorage; });
  const auto* const odd =
      guest != nullptr ? guest : FirstOf(*offer, [](const auto& one) { return !HasRole(one); });
  const auto* const other = FirstOf(*offer, [odd](const auto& one) { return one.kind != odd->kind; });
  return SayMixed(port, name(odd), name(other));
}

}  // namespace kaori::usb
