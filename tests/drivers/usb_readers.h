// Two other readers of USB descriptors, written after their sources: the kernel, which decides what a device is, and udev, which
// this project does not ask.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/decode/usb_offer.h"

namespace kaori::tests {

using UsbFile = std::vector<std::uint8_t>;

// A device descriptor as the kernel keeps it; the configurations' number is set by KernelReads.
inline UsbFile UsbDeviceDescriptor(std::uint16_t vendor = 0x1209, std::uint16_t product = 1) {
  const auto low = [](std::uint16_t value) { return static_cast<std::uint8_t>(value & 0xFFU); };
  const auto high = [](std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8U); };
  return {18, 1, 0, 2, 0, 0, 0, 64, low(vendor), high(vendor), low(product), high(product), 0, 1, 1, 2, 0, 0};
}

// What the kernel knows of a device afterwards.
struct KernelView {
  UsbFile file;                                      // `descriptors` in sysfs.
  std::vector<decode::OfferedInterface> interfaces;  // To which it would bind drivers.
};

// One configuration: usb_parse_configuration and usb_parse_interface of drivers/usb/core/config.c, Linux 6.12. False where
// the kernel gives the device up.
inline bool KernelReadsOne(const UsbFile& sent, KernelView& view) {
  constexpr std::size_t kMostInterfaces = 32, kMostSettings = 128;  // USB_MAXINTERFACES, USB_MAXALTSETTING.
  if (sent.size() < 9 || sent[1] != 2 || sent[0] < 9 || sent[0] > sent.size()) return false;
  std::map<std::uint8_t, std::vector<std::uint8_t>> settings;
  std::size_t at = sent[0];
  for (; sent.size() - at >= 2 && sent[at] >= 2 && sent[at] <= sent.size() - at; at += sent[at]) {
    const auto* const one = &sent[at];
    if (one[1] != 4 || one[0] < 9) continue;
    if (settings.size() == kMostInterfaces && !settings.contains(one[2])) continue;
    auto& seen = settings[one[2]];
    if (seen.size() == kMostSettings || std::ranges::find(seen, one[3]) != seen.end()) continue;
    seen.push_back(one[3]);
    view.interfaces.push_back({.kind = decode::UsbClass{one[5]}, .subclass = one[6], .protocol = one[7]});
  }
  view.file.insert(view.file.end(), sent.begin(), sent.begin() + static_cast<std::ptrdiff_t>(at));
  return true;
}

// All of them, as usb_get_configuration and descriptors_read do it; nothing where there is no such device then.
inline std::optional<KernelView> KernelReads(UsbFile device, const std::vector<UsbFile>& configurations) {
  constexpr std::size_t kMostConfigurations = 8, kFileBytes = 18 + 65535;  // USB_MAXCONFIG; descriptors_read.
  const std::size_t count = std::min(configurations.size(), kMostConfigurations);
  device[17] = static_cast<std::uint8_t>(count);
  KernelView view{.file = std::move(device), .interfaces = {}};
  for (std::size_t n = 0; n < count; ++n)
    if (!KernelReadsOne(configurations[n], view)) return std::nullopt;
  if (count == 0) return std::nullopt;
  view.file.resize(std::min(view.file.size(), kFileBytes));
  return view;
}

// ID_USB_INTERFACES: dev_if_packed_info of src/udev/udev-builtin-usb_id.c, systemd 252.
inline std::string UdevReads(const UsbFile& file) {
  constexpr std::size_t kInterfaceBytes = 9, kRoom = 512;
  std::string packed;
  for (std::size_t at = 0; at + kInterfaceBytes < file.size() && packed.size() + 7 < kRoom - 2;) {
    const auto* const one = &file[at];
    if (one[0] < 3 || one[0] > file.size() - kInterfaceBytes) break;
    at += one[0];
    if (one[1] != 4) continue;
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), ":%02x%02x%02x", one[5], one[6], one[7]);
    if (packed.find(text.data()) == std::string::npos) packed += text.data();
  }
  return packed.empty() ? packed : packed + ":";
}

}  // namespace kaori::tests
