#include "render/passes/quality.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace kaori::passes {

// Mesa's drivers without a card; virgl says the name of the driver behind it, in any letters.
Quality QualityFor(std::string_view renderer) {
  constexpr std::array<std::string_view, 4> kSoftware{"llvmpipe", "softpipe", "swrast", "swiftshader"};
  std::string lower(renderer);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool software = std::ranges::any_of(
      kSoftware, [&](std::string_view name) { return lower.find(name) != std::string::npos; });
  return software ? Quality::kBasic : Quality::kFinest;
}

std::string_view NameOf(Quality quality) {
  switch (quality) {
    case Quality::kBasic:
      return "basic";
    case Quality::kFine:
      return "fine";
    case Quality::kFinest:
      return "finest";
  }
  return "";
}

}  // namespace kaori::passes
