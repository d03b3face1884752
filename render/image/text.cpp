#include "render/image/text.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <string>
#include <vector>

#include "render/image/font.h"
#include "render/image/utf8.h"

namespace kaori::image {
namespace {

// FreeType's lengths are in 64ths of a pixel.
constexpr int kUnit = 64;

constexpr const char* kEllipsis = "\u2026";

// C0, DEL and C1.
bool IsControl(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

// The glyph of a letter; 0, the font's box, where it has no such letter. Control characters are spaces.
FT_UInt GlyphOf(FT_Face face, char32_t code) {
  return FT_Get_Char_Index(face, IsControl(code) ? U' ' : code);
}

// Calls `each(glyph, x)` with x in 64ths of a pixel from the line's left end; returns where the line ends.
template <class Each>
// Left to right, with the font's kerning; scripts that join their letters are not shaped.
FT_Pos Walk(FT_Face face, std::string_view text, const Each& each) {
  FT_Pos x = 0;
  FT_UInt before = 0;
  while (!text.empty()) {
    const Letter letter = FirstLetter(text);
    text.remove_prefix(letter.bytes);
    const FT_UInt glyph = GlyphOf(face, letter.code);
    FT_Vector kern{};
    if (before != 0) FT_Get_Kerning(face, before, glyph, FT_KERNING_DEFAULT, &kern);
    before = glyph;
    x += kern.x;
    if (FT_Load_Glyph(face, glyph, FT_LOAD_TARGET_LIGHT) != 0) continue;
    each(x);
    x += face->glyph->advance.x;
  }
  return x;
}

// Of codes, not of light: as people expect text on a screen.
std::uint8_t Mix(std::uint8_t from, std::uint8_t to, unsigned coverage) {
  return static_cast<std::uint8_t>((from * (255U - coverage) + to * coverage + 127U) / 255U);
}

void Cover(std::uint8_t* pixel, const TextStyle& style, std::uint8_t coverage) {
  for (std::size_t i = 0; i < 3; ++i) pixel[i] = Mix(pixel[i], style.rgb[i], coverage);
  pixel[3] = std::max(pixel[3], coverage);
}

// (left, top): the bitmap's upper left pixel; row 0 of the picture is its lowest.
void Stamp(const FT_Bitmap& bitmap, const TextStyle& style, int left, int top, Picture& into) {
  for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
    const int y = top - row;
    if (y < 0 || y >= into.height_px) continue;
    const int first = std::max(0, -left);
    const int last = std::min(static_cast<int>(bitmap.width), into.width_px - left);
    // FreeType's rows run down; their pitch is positive for such bitmaps.
    for (int column = first; column < last; ++column) {
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(into.width_px) +
                         static_cast<std::size_t>(left + column);
      Cover(into.rgbx.data() + pixel * 4, style, bitmap.buffer[row * bitmap.pitch + column]);
    }
  }
}

int Ceil(FT_Pos length) {
  return static_cast<int>((length + kUnit - 1) / kUnit);
}

// FreeType counts below the baseline as negative.
int Descent_px(FT_Face face) {
  return Ceil(-face->size->metrics.descender);
}

}  // namespace

void Lettering::EndLibrary::operator()(FT_LibraryRec_* library) const {
  FT_Done_FreeType(library);
}
void Lettering::EndFace::operator()(FT_FaceRec_* face) const {
  FT_Done_Face(face);
}

// The face borrows the library and the font's bytes.
Result<Lettering> Lettering::Open() {
  Lettering made;
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return Fail(std::errc::not_enough_memory, "begin FreeType");
  made.library_.reset(library);
  const auto font = FontBytes();
  const auto* bytes = reinterpret_cast<const FT_Byte*>(font.data());
  FT_Face face = nullptr;
  // The font's bytes live as long as the program, as FreeType demands.
  if (FT_New_Memory_Face(library, bytes, static_cast<FT_Long>(font.size()), 0, &face) != 0)
    return Fail(std::errc::not_enough_memory, "open the font");
  made.face_.reset(face);
  return made;
}

void Lettering::SetSize(int size_px) {
  // FreeType would refuse sizes beyond, and leave the one that was set.
  size_px = std::clamp(size_px, 1, kMostTextSize_px);
  if (size_px == size_px_) return;
  FT_Set_Pixel_Sizes(face_.get(), 0, static_cast<FT_UInt>(size_px));
  size_px_ = size_px;
}

int Lettering::width_px(std::string_view text, int size_px) {
  SetSize(size_px);
  return Ceil(Walk(face_.get(), text, [](FT_Pos) {}));
}

int Lettering::height_px(int size_px) {
  SetSize(size_px);
  return Ceil(face_->size->metrics.ascender) + Descent_px(face_.get());
}

// The baseline lies the descent above the box's lower edge.
void Lettering::Draw(std::string_view text, const TextStyle& style, int x_px, int y_px, Picture& into) {
  SetSize(style.size_px);
  const int baseline = y_px + Descent_px(face_.get());
  const FT_GlyphSlot slot = face_->glyph;
  Walk(face_.get(), text, [&](FT_Pos x) {
    if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) return;
    const int left = x_px + static_cast<int>(x / kUnit) + slot->bitmap_left;
    Stamp(slot->bitmap, style, left, baseline + slot->bitmap_top - 1, into);
  });
}

// Beginnings grow by whole letters, never by half of one; the longest that fits with its ellipsis is found by
// halving.
std::string Shorten(Lettering& lettering, std::string_view text, int size_px, int width_px) {
  if (lettering.width_px(text, size_px) <= width_px) return std::string(text);
  std::vector<std::size_t> ends{0};  // Of beginnings, each a letter longer.
  while (ends.back() < text.size()) ends.push_back(ends.back() + FirstLetter(text.substr(ends.back())).bytes);
  const auto cut = [&](std::size_t end) { return std::string(text.substr(0, end)) + kEllipsis; };
  const auto first_too_long = std::partition_point(ends.begin(), ends.end(), [&](std::size_t end) {
    return lettering.width_px(cut(end), size_px) <= width_px;
  });
  return first_too_long == ends.begin() ? std::string() : cut(*(first_too_long - 1));
}

}  // namespace kaori::image
