#include "render/image/text.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_GZIP_H
#include FT_SYSTEM_H

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/utf8.h"
#include "render/image/font.h"

namespace kaori::image {
namespace {

// FreeType's lengths are in 64ths of a pixel.
constexpr int kUnit = 64;

constexpr const char* kEllipsis = "\u2026";

// A gzip file's content, whose length stands in its last four bytes (RFC 1952); empty where it cannot be unpacked.
std::vector<FT_Byte> Unpacked(std::span<const std::byte> file) {
  FT_MemoryRec_ memory{nullptr,
                       [](FT_Memory, long bytes) { return std::malloc(static_cast<std::size_t>(bytes)); },
                       [](FT_Memory, void* block) { std::free(block); },
                       [](FT_Memory, long, long bytes, void* block) {
                         return std::realloc(block, static_cast<std::size_t>(bytes));
                       }};
  FT_ULong bytes = 0;
  for (std::size_t i = 0; i < 4; ++i)
    bytes = bytes << 8U | std::to_integer<FT_ULong>(file[file.size() - 1 - i]);
  std::vector<FT_Byte> content(bytes);
  const auto* packed = reinterpret_cast<const FT_Byte*>(file.data());
  if (FT_Gzip_Uncompress(&memory, content.data(), &bytes, packed, static_cast<FT_ULong>(file.size())) != 0)
    return {};
  return content;
}

// Unpacked once, by whoever draws first, in some milliseconds; the font's bytes live as long as the program, as
// FreeType demands.
std::span<const FT_Byte> JapaneseFont() {
  static const std::vector<FT_Byte> font = Unpacked(PackedJapaneseFont());
  return font;
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

// The faces borrow the library and the fonts' bytes.
Result<Lettering> Lettering::Open() {
  Lettering made;
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return Fail(std::errc::not_enough_memory, "begin FreeType");
  made.library_.reset(library);
  const auto first = FontBytes();
  const std::array fonts{std::span(reinterpret_cast<const FT_Byte*>(first.data()), first.size()),
                         JapaneseFont()};
  for (std::size_t i = 0; i < fonts.size(); ++i) {
    FT_Face face = nullptr;
    if (FT_New_Memory_Face(library, fonts[i].data(), static_cast<FT_Long>(fonts[i].size()), 0, &face) != 0)
      return Fail(std::errc::not_enough_memory, "open the font");
    made.faces_[i].reset(face);
  }
  return made;
}

// Index 0 is a font's box, which the first font draws for what both lack.
Lettering::Glyph Lettering::Find(char32_t code) const {
  const FT_ULong wanted = utf8::IsControl(code) ? U' ' : code;
  for (const auto& face : faces_)
    if (const FT_UInt index = FT_Get_Char_Index(face.get(), wanted); index != 0) return {face.get(), index};
  return {faces_.front().get(), 0};
}

// Left to right, with kerning between letters of one font; scripts that join their letters are not shaped. Both
// fonts stand on one baseline in one size: the middle of a kanji comes to 0.38 of it above the baseline, that of
// DejaVu's capitals to 0.365.
template <class Each>
FT_Pos Lettering::Walk(std::string_view text, const Each& each) const {
  FT_Pos x = 0;
  Glyph before;
  while (!text.empty()) {
    const utf8::Letter letter = utf8::FirstLetter(text);
    text.remove_prefix(letter.bytes);
    const Glyph glyph = Find(letter.code);
    FT_Vector kern{};
    if (before.index != 0 && before.face == glyph.face)
      FT_Get_Kerning(glyph.face, before.index, glyph.index, FT_KERNING_DEFAULT, &kern);
    before = glyph;
    x += kern.x;
    if (FT_Load_Glyph(glyph.face, glyph.index, FT_LOAD_TARGET_LIGHT) != 0) continue;
    each(glyph.face, x);
    x += glyph.face->glyph->advance.x;
  }
  return x;
}

void Lettering::SetSize(int size_px) {
  // FreeType would refuse sizes beyond, and leave the one that was set.
  size_px = std::clamp(size_px, 1, kMostTextSize_px);
  if (size_px == size_px_) return;
  for (const auto& face : faces_) FT_Set_Pixel_Sizes(face.get(), 0, static_cast<FT_UInt>(size_px));
  size_px_ = size_px;
}

int Lettering::width_px(std::string_view text, int size_px) {
  SetSize(size_px);
  return Ceil(Walk(text, [](FT_Face, FT_Pos) {}));
}

int Lettering::height_px(int size_px) {
  SetSize(size_px);
  return Ceil(faces_.front()->size->metrics.ascender) + Descent_px(faces_.front().get());
}

// The baseline lies the descent above the box's lower edge.
void Lettering::Draw(std::string_view text, const TextStyle& style, int x_px, int y_px, Picture& into) {
  SetSize(style.size_px);
  const int baseline = y_px + Descent_px(faces_.front().get());
  Walk(text, [&](FT_Face face, FT_Pos x) {
    const FT_GlyphSlot slot = face->glyph;
    if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) return;
    const int left = x_px + static_cast<int>(x / kUnit) + slot->bitmap_left;
    Stamp(slot->bitmap, style, left, baseline + slot->bitmap_top - 1, into);
  });
}

int GuessWidth_px(std::string_view text, int size_px, int narrow) {
  int hundredths = 0;
  while (!text.empty()) {
    const utf8::Letter letter = utf8::FirstLetter(text);
    text.remove_prefix(letter.bytes);
    hundredths += utf8::IsWide(letter.code) ? 100 : narrow;
  }
  return hundredths * size_px / 100;
}

// Beginnings grow by whole letters, never by half of one; the longest that fits with its ellipsis is found by
// halving.
std::string Shorten(Lettering& lettering, std::string_view text, int size_px, int width_px) {
  if (lettering.width_px(text, size_px) <= width_px) return std::string(text);
  std::vector<std::size_t> ends{0};  // Of beginnings, each a letter longer.
  while (ends.back() < text.size())
    ends.push_back(ends.back() + utf8::FirstLetter(text.substr(ends.back())).bytes);
  const auto cut = [&](std::size_t end) { return std::string(text.substr(0, end)) + kEllipsis; };
  const auto first_too_long = std::partition_point(ends.begin(), ends.end(), [&](std::size_t end) {
    return lettering.width_px(cut(end), size_px) <= width_px;
  });
  return first_too_long == ends.begin() ? std::string() : cut(*(first_too_long - 1));
}

}  // namespace kaori::image
