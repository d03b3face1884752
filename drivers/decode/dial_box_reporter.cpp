#include "drivers/decode/dial_box_reporter.h"

#include <algorithm>
#include <limits>

#include "firmware/wire/dial_box.h"

namespace kaori::decode {

// Counts wrap, so that their difference is taken without a sign.
std::size_t DialBoxReporter::Report(const std::array<std::int32_t, kMaxDials>& counts,
                                    std::uint32_t buttons_down, std::span<std::uint8_t> into) {
  constexpr std::int32_t kMost = std::numeric_limits<std::int16_t>::max();
  wire::DialBoxReport report{.buttons_down = buttons_down, .turned = {}};
  has_rest_ = false;
  for (std::size_t n = 0; n < told_.size(); ++n) {
    const auto told = static_cast<std::uint32_t>(told_[n]);
    const auto turn = static_cast<std::int32_t>(static_cast<std::uint32_t>(counts[n]) - told);
    const std::int32_t said = std::clamp(turn, -kMost, kMost);
    has_rest_ |= said != turn;
    report.turned[n] = static_cast<std::int16_t>(said);
    told_[n] = static_cast<std::int32_t>(told + static_cast<std::uint32_t>(said));
  }
  const auto bytes = wire::Encode(report);
  const std::size_t count = std::min(bytes.size(), into.size());
  std::copy_n(bytes.begin(), count, into.begin());
  return count;
}

}  // namespace kaori::decode
