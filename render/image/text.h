// Lines of text in pictures, with a font that the program carries: nothing is looked up at run time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "drivers/base/result.h"
#include "render/image/png.h"

struct FT_FaceRec_;
// FreeType's own types, declared here so that its headers stay in one file.
struct FT_LibraryRec_;

namespace kaori::image {

// How a line looks.
struct TextStyle {
  // Of the em square; 1 to kMostTextSize_px, clamped.
  int size_px = 16;
  // As stored in the picture.
  std::array<std::uint8_t, 3> rgb{255, 255, 255};
};

// Larger letters would be bitmaps of megabytes each.
inline constexpr int kMostTextSize_px = 400;

// DejaVu Sans, and for letters that it lacks Motoya L Cedar, which has the Japanese ones. One thread at a time;
// every function may allocate, so captions are drawn when they change, not in each frame. Text is UTF-8; what is
// no UTF-8 is drawn as U+FFFD, a letter that both fonts lack as the first one's box, and control characters as
// spaces.
class Lettering {
 public:
  // The first call of a process unpacks the Japanese font, which takes some milliseconds. Errors: not_enough_memory.
  static Result<Lettering> Open();

  Lettering(Lettering&&) noexcept = default;
  Lettering& operator=(Lettering&&) noexcept = default;
  Lettering(const Lettering&) = delete;
  Lettering& operator=(const Lettering&) = delete;
  ~Lettering() = default;

  // The box of a line: what Draw moves on to the right, and how high letters with all their strokes are.
  int width_px(std::string_view text, int size_px);
  // Of every line of this size, whatever letters it has.
  int height_px(int size_px);

  // Draws one line; its box's lower left corner comes to (x_px, y_px), row 0 at the bottom. What lies outside
  // the picture is cut. X becomes the letters' coverage where that is more than what stood there: in a
  // picture that was blank it is their mask.
  void Draw(std::string_view text, const TextStyle& style, int x_px, int y_px, Picture& into);

 private:
  struct EndLibrary {
    void operator()(FT_LibraryRec_* library) const;
  };
  struct EndFace {
    void operator()(FT_FaceRec_* face) const;
  };

  Lettering() = default;

  // Sets the fonts' size in pixels where it is another.
  void SetSize(int size_px);
  // The font that has the letter, and its glyph there; that of a space for a control character.
  struct Glyph {
    FT_FaceRec_* face = nullptr;
    unsigned index = 0;
  };
  Glyph Find(char32_t code) const;
  // Calls `each(face, x)` with the letter loaded in its font, x in 64ths of a pixel from the line's left end; returns
  // where the line ends.
  template <class Each>
  long Walk(std::string_view text, const Each& each) const;

  // Outlives the faces.
  std::unique_ptr<FT_LibraryRec_, EndLibrary> library_;
  // In the order in which a letter is looked for; the first one gives lines their height.
  std::array<std::unique_ptr<FT_FaceRec_, EndFace>, 2> faces_;
  int size_px_ = 0;
};

// About how wide a line is, without asking the fonts, for callers who may take no time: a wide letter
// (utf8::IsWide) has the width of its size, and each other one `narrow` hundredths of that. Pure.
int GuessWidth_px(std::string_view text, int size_px, int narrow);

// The beginning of `text` that fits into `width_px`, with "…" where something was cut; empty where not even
// that fits.
std::string Shorten(Lettering& lettering, std::string_view text, int size_px, int width_px);

}  // namespace kaori::image
