// Any device with any reports: u16 length of the descriptor, the descriptor, then u8 length and bytes of each
// report. Length 255 pulls the cable and plugs it in again.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/decode/dial_box.h"
#include "drivers/decode/joystick.h"
#include "drivers/decode/keyboard.h"
#include "drivers/decode/pointer.h"
#include "tests/fuzz/check.h"

namespace kaori::fuzz {
namespace {

using Bytes = std::span<const std::uint8_t>;
constexpr std::uint8_t kPulled = 255;

Bytes Consume(Bytes& from, std::size_t bytes) {
  const Bytes taken = from.first(std::min(bytes, from.size()));
  from = from.subspan(taken.size());
  return taken;
}

void Check(const decode::StickSample& stick) {
  for (const float axis : {stick.x, stick.y, stick.twist})
    Promise(std::isfinite(axis) && std::abs(axis) <= 1, "an axis lies in -1 .. 1");
  Promise(stick.slider >= 0 && stick.slider <= 1, "a slider lies in 0 .. 1");
  Promise(stick.hat >= -1 && stick.hat <= 7, "a hat has eight ways");
}

void Check(const decode::KeySample& keyboard) {
  Promise((keyboard.keys.down[0] & 0x0Fu) == 0, "error codes are no keys");
}

void Check(const decode::PointerSample& pointer) {
  for (const float place : {pointer.x, pointer.y})
    Promise(place >= 0 && place <= 1, "a pointer stays on the picture");
}

void Check(const decode::DialSample&) {}

template <class Decoder>
void Play(Decoder decoder, Bytes reports) {
  Time at{};
  while (!reports.empty()) {
    const std::uint8_t length = Consume(reports, 1)[0];
    if (length == kPulled) {
      decoder.Release();
    } else {
      const Time before = decoder.sample().at;
      const auto sample = decoder.Decode(Consume(reports, length), at += std::chrono::milliseconds(1));
      Promise(sample || decoder.sample().at == before, "a refused report changes nothing");
    }
    Check(decoder.sample());
  }
}

}  // namespace
}  // namespace kaori::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  fuzz::Bytes input(data, size);
  const fuzz::Bytes head = fuzz::Consume(input, 2);
  if (head.size() < 2) return 0;
  const fuzz::Bytes descriptor = fuzz::Consume(input, head[0] + std::size_t{head[1]} * 256);
  ports::HidIdentity identity{.port = "fuzz", .vendor = 0, .product = 0, .name = "", .descriptor = {}};
  identity.descriptor.assign(descriptor.begin(), descriptor.end());
  if (auto box = decode::DialBoxDecoder::For(identity)) {
    box->LampReport(0xA5A5A5A5u);
    fuzz::Play(std::move(*box), input);
  }
  if (auto stick = decode::JoystickDecoder::For(identity)) fuzz::Play(std::move(*stick), input);
  if (auto keyboard = decode::KeyboardDecoder::For(identity)) fuzz::Play(std::move(*keyboard), input);
  if (auto pointer = decode::PointerDecoder::For(identity)) fuzz::Play(std::move(*pointer), input);
  return 0;
}
