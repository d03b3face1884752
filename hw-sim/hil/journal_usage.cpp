#include "hw-sim/hil/journal_usage.h"

#include <cstdlib>
#include <string_view>

namespace kaori::hil {

// A letter follows the number at once: "B", "K", "M" or "G".
Result<double> JournalIn_mb(const std::string& said) {
  constexpr std::string_view kBefore = "take up ", kUnits = "BKMG";
  const auto at = said.find(kBefore);
  if (at == std::string::npos)
    return FailInput("journalctl does not say what the journal takes, but \"" + said + "\"");
  char* unit = nullptr;
  double bytes = std::strtod(said.c_str() + at + kBefore.size(), &unit);
  const auto power = kUnits.find(*unit);
  if (*unit == '\0' || power == kUnits.npos)
    return FailInput("journalctl says a size without a unit: \"" + said + "\"");
  for (std::size_t n = 0; n < power; ++n) bytes *= 1024;
  return bytes / 1e6;
}

}  // namespace kaori::hil
