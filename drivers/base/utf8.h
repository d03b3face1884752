// UTF-8: its letters, how wide they stand, and foreign words made fit to be shown and logged.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kaori::utf8 {

// A code point and its length in the text.
struct Letter {
  char32_t code = 0;
  // How many of the text it is made of; 1 at least.
  std::size_t bytes = 0;
};

// The first letter of `text`, which must not be empty. A byte that begins no valid sequence (too short, too
// long for its code, a surrogate, above U+10FFFF) is U+FFFD, and one byte long.
Letter FirstLetter(std::string_view text);

// C0, DEL and C1: characters that order something and are no letters.
bool IsControl(char32_t code);

// Whether a letter is as wide as it is high: kana, kanji, Hangul and full-width forms, and what else has the
// East Asian Width W or F (Unicode Standard Annex 11, by blocks).
bool IsWide(char32_t code);

// How many columns the text takes where every letter has one and a wide one has two, as in a terminal.
std::size_t Columns(std::string_view text);

// Words of a stick, a file or a device as they can be shown and logged. What is no UTF-8, controls, and marks
// that are not seen and reorder, join or hide letters are "?", one for each byte or letter: they would forge
// lines of the log, or make two names look alike. What takes more than `most` columns is cut between two
// letters and ends in "...", all of it within `most`, which is 3 at least. Pure.
std::string Printable(std::string_view text, std::size_t most);

}  // namespace kaori::utf8
