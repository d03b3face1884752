// The Elgato Stream Deck: how its picture keys want their pictures, and the bytes that it is sent and sends.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace kaori::decode {

// How a deck's keys take a picture. All decks of one shape show the same files.
struct DeckShape {
  int key_px = 0;  // A key is square.
  // How the picture is turned before it is sent: by half a turn, or rows and columns change places.
  enum class Way : std::uint8_t { kUpright, kHalfTurn, kSwapped };
  Way way = Way::kUpright;
  bool is_bitmap = false;  // A Windows bitmap of 24 bits a point; else a JPEG.

  // ".jpg" or ".bmp".
  std::string_view suffix() const { return is_bitmap ? ".bmp" : ".jpg"; }
};

// Every shape that there is, for whoever makes pictures: MK.2 and V2, XL and Neo, +, Mini.
inline constexpr std::array<DeckShape, 4> kDeckShapes{{{72, DeckShape::Way::kHalfTurn, false},
                                                       {96, DeckShape::Way::kHalfTurn, false},
                                                       {120, DeckShape::Way::kUpright, false},
                                                       {80, DeckShape::Way::kSwapped, true}}};

// What a deck of these ids has. Bytes by the maker's published HID reference; those of the Mini, which it leaves
// out, by public descriptions.
struct StreamDeck {
  int keys = 0;  // 0: it is no deck that is known.
  DeckShape shape{};
};
StreamDeck StreamDeckOf(std::uint16_t vendor, std::uint16_t product);

// Whether an input report tells of keys. A deck with dials or a touch screen tells of them by the same number
// and another command, whose bytes stand where those of keys would.
enum class DeckReport : std::uint8_t { kKeys, kOther, kTorn };
DeckReport DeckReportOf(const StreamDeck& deck, std::span<const std::uint8_t> report);

// The output reports, 1024 bytes each and to be sent in this order, that show a picture on a key, 0 the upper
// left one. `picture` is a file of the deck's shape. Pages begin with 8 bytes, of the Mini with 16:
//   JPEG     02 07 key last length16 number16
//   bitmap   02 01 number 00 last key+1, then zeros
std::vector<std::vector<std::uint8_t>> PicturePages(const StreamDeck& deck, int key,
                                                    std::span<const std::uint8_t> picture);

}  // namespace kaori::decode
