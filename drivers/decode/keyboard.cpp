#include "drivers/decode/keyboard.h"

#include <utility>

#include "drivers/decode/known_descriptors.h"
#include "drivers/decode/recognise.h"
#include "drivers/decode/usages.h"

namespace kaori::decode {
namespace {

// Usages 00..03 are no keys: none, roll-over, self-test failed, undefined error.
constexpr Usage kFirstError = (kKeyboardPage << 16) | 0x01;
constexpr Usage kLastError = (kKeyboardPage << 16) | 0x03;
// Bits 0 to 3 of the first word: the usages that are no keys.
constexpr std::uint32_t kNoKeys = 0x0F;

}  // namespace

Result<KeyboardDecoder> KeyboardDecoder::For(const ports::HidIdentity& identity) {
  // A keyboard in the boot protocol has a fixed report, and may be without a descriptor here.
  auto layout = identity.descriptor.empty() ? ReadReportLayout(BootKeyboardDescriptor()) : LayoutOf(identity);
  if (!layout) return tl::unexpected(layout.error());
  if (Recognise(*layout) != DeviceKind::kKeyboard)
    return Fail(std::errc::not_supported, "read " + identity.port + " as a keyboard");
  return KeyboardDecoder(std::move(*layout));
}

KeyboardDecoder::KeyboardDecoder(ReportLayout layout) : layout_(std::move(layout)), keys_(kKeyboardPage, 0) {}

// A report that cannot be read, or that names the roll-over error, leaves all keys as they were.
Result<KeySample> KeyboardDecoder::Decode(std::span<const std::uint8_t> report, Time at) {
  const auto input = OpenInput(layout_, report);
  if (!input) return tl::unexpected(input.error());
  // Too many keys at a time: the keyboard cannot tell which, so all stay as they were.
  if (!is_phantom(*input)) {
    auto held = keys_.Read(layout_, *input);
    held[0] &= ~kNoKeys;
    sample_.keys.Become(held);
  }
  sample_.at = at;
  return sample_;
}

bool KeyboardDecoder::is_phantom(const InputReport& report) const {
  // One entry is enough: a keyboard that cannot tell fills all of its places with the error.
  bool phantom = false;
  VisitHeld(layout_, report, kKeyboardPage,
            [&](Usage usage) { phantom = phantom || (usage >= kFirstError && usage <= kLastError); });
  return phantom;
}

void KeyboardDecoder::Release() {
  keys_.Release();
  sample_.keys.Become({});
}

}  // namespace kaori::decode
