// The Elgato Stream Deck: what its picture keys are sent. Bytes by the maker's published HID reference.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace kaori::decode {

// What a deck of these ids has; none: it is no deck of this protocol (the Mini has another).
struct StreamDeck {
  int keys = 0;  // 0: no deck.
  int key_px = 0;
  bool upside_down = false;  // Its pictures are sent turned by 180 degrees.
};
StreamDeck StreamDeckOf(std::uint16_t vendor, std::uint16_t product);

// The output reports, 1024 bytes each and to be sent in this order, that show a JPEG on a key, 0 the upper
// left one. The picture has the key's size. Page n of them is cut behind 8 bytes of head: 02 07 key last
// length16 n16.
std::vector<std::vector<std::uint8_t>> PicturePages(int key, std::span<const std::uint8_t> jpeg);

}  // namespace kaori::decode
