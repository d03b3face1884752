// How finely the figure is drawn: what the machine can draw in time.
#pragma once

#include <cstdint>
#include <string_view>

namespace kaori::passes {

enum class Quality : std::uint8_t {
  // For processors: skin is lit a vertex at a time.
  kBasic,
  // For graphics cards: skin is lit a pixel at a time, with pores and with shadows of the key lamp.
  kFine,
  // For cards with time left: as kFine, and light spreads within skin (scatter.h).
  kFinest,
};

// By the driver's own name (gl::Context::renderer): kBasic where it draws on a processor, as llvmpipe does,
// also behind a virtual machine's card; else kFinest. Whether a card is fast enough is to be measured.
Quality QualityFor(std::string_view renderer);

// For people: "basic", "fine", "finest".
std::string_view NameOf(Quality quality);

}  // namespace kaori::passes
