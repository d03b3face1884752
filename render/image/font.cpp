#include "render/image/font.h"

// The assembler reads the files: 550 and 590 kB would take a compiler seconds. KAORI_FONT and KAORI_JAPANESE_FONT
// are their paths, set by CMake.
asm(R"(
  .pushsection .rodata
  .balign 16
  .global kaori_font_begin
  .global kaori_font_end
kaori_font_begin:
  .incbin ")" KAORI_FONT R"("
kaori_font_end:
  .balign 16
  .global kaori_japanese_font_begin
  .global kaori_japanese_font_end
kaori_japanese_font_begin:
  .incbin ")" KAORI_JAPANESE_FONT R"("
kaori_japanese_font_end:
  .popsection
)");

extern "C" const std::byte kaori_font_begin[];  // NOLINT(readability-identifier-naming): the label above.
extern "C" const std::byte kaori_font_end[];    // NOLINT(readability-identifier-naming)
extern "C" const std::byte kaori_japanese_font_begin[];  // NOLINT(readability-identifier-naming)
extern "C" const std::byte kaori_japanese_font_end[];    // NOLINT(readability-identifier-naming)

namespace kaori::image {

std::span<const std::byte> FontBytes() {
  return {kaori_font_begin, kaori_font_end};
}

std::span<const std::byte> PackedJapaneseFont() {
  return {kaori_japanese_font_begin, kaori_japanese_font_end};
}

}  // namespace kaori::image
