// Any bytes on the line of a serial dial box: the kind of box, then pairs of a wait in quarters of a millisecond and a byte.
#include <cstdlib>
#include <span>

#include "drivers/decode/serial_dials.h"
#include "tests/fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  constexpr int kPerTurn = 256;
  std::span<const std::uint8_t> input(data, size);
  if (input.empty()) return 0;
  decode::SerialDialSession session(static_cast<decode::SerialBox>(input[0] % 3), kPerTurn);
  Time at = Time{} + std::chrono::seconds(1);
  for (input = input.subspan(1); input.size() >= 2; input = input.subspan(2)) {
    at += std::chrono::microseconds(250) * input[0];
    const auto before = session.decoder().counts();
    session.Due(at);
    const bool changed = session.Accept(input[1], at);
    int turned = 0;
    for (std::size_t n = 0; n < before.size(); ++n) {
      const auto turn = static_cast<std::int32_t>(static_cast<std::uint32_t>(session.decoder().counts()[n]) -
                                                  static_cast<std::uint32_t>(before[n]));
      turned += turn != 0;
      fuzz::Promise(std::abs(turn) <= kPerTurn / 3, "one byte turns no dial by more than a third");
    }
    fuzz::Promise(turned <= 1, "one byte turns one dial at most");
    fuzz::Promise(changed || turned == 0, "a turn is a change");
  }
  return 0;
}
