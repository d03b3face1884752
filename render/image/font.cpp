#include "render/image/font.h"

// The assembler reads the file: 750 kB would take a compiler seconds. KAORI_FONT is its path, set by CMake.
asm(R"(
  .pushsection .rodata
  .balign 16
  .global kaori_font_begin
  .global kaori_font_end
kaori_font_begin:
  .incbin ")" KAORI_FONT R"("
kaori_font_end:
  .popsection
)");

extern "C" const std::byte kaori_font_begin[];  // NOLINT(readability-identifier-naming): the label above.
extern "C" const std::byte kaori_font_end[];    // NOLINT(readability-identifier-naming)

namespace kaori::image {

std::span<const std::byte> FontBytes() {
  return {kaori_font_begin, kaori_font_end};
}

}  // namespace kaori::image
