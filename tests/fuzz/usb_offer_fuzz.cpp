// Any bytes as the descriptors of a USB device: as the file of sysfs, and as what a device sends, which the kernel has read before.
// Each configuration that is sent begins with two bytes, its length.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "drivers/decode/usb_offer.h"
#include "tests/drivers/usb_readers.h"
#include "tests/fuzz/check.h"

namespace kaori::fuzz {
namespace {

std::vector<tests::UsbFile> Sent(std::span<const std::uint8_t> input) {
  std::vector<tests::UsbFile> configurations;
  while (input.size() >= 2) {
    const std::size_t bytes = std::min<std::size_t>(input[0] | (input[1] << 8U), input.size() - 2);
    configurations.emplace_back(input.begin() + 2, input.begin() + 2 + static_cast<std::ptrdiff_t>(bytes));
    input = input.subspan(2 + bytes);
  }
  return configurations;
}

}  // namespace
}  // namespace kaori::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  const auto offer = decode::ReadUsbOffer({data, size});
  if (!offer) fuzz::Promise(offer.error().message().starts_with("byte "), "a refusal names its byte");
  if (offer) fuzz::Promise(!offer->interfaces.empty(), "an offer is not empty");
  const auto kernel = tests::KernelReads(tests::UsbDeviceDescriptor(), fuzz::Sent({data, size}));
  if (!kernel) return 0;
  const auto seen = decode::ReadUsbOffer(kernel->file);
  if (!seen) return 0;
  for (const decode::OfferedInterface& one : kernel->interfaces)
    fuzz::Promise(std::ranges::find(seen->interfaces, one) != seen->interfaces.end(),
                  "what the kernel would bind a driver to is offered");
  return 0;
}
