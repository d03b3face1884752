#include "appliance/authoring/keys/key_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "appliance/authoring/keys/key_file.h"
#include "appliance/authoring/keys/key_scene.h"
#include "appliance/core/roles/own_buttons.h"
#include "appliance/programs/stage/key_files.h"
#include "render/image/text.h"

namespace kaori::authoring {
namespace {

// A scene is drawn once, many times larger than any key, and averaged for each size: a key's points are few.
constexpr int kDrawn_px = 480;
// Of a key's height.
constexpr float kNameHeight = 0.15F, kTileTextHeight = 0.18F, kFrameWidth = 0.05F;
// What is not on is seen, and far from what is.
constexpr float kDimmed = 0.45F;
constexpr std::array<std::uint8_t, 3> kGround{28, 31, 39}, kFrameColour{255, 178, 64};

std::uint8_t* At(image::Picture& picture, int x, int y) {
  return picture.rgbx.data() + static_cast<std::ptrdiff_t>(y * picture.width_px + x) * 4;
}

image::Picture Filled(int side_px) {
  image::Picture picture = image::Picture::Blank(side_px, side_px);
  const std::ptrdiff_t pixels = std::ptrdiff_t{side_px} * side_px;
  for (std::ptrdiff_t n = 0; n < pixels; ++n) std::ranges::copy(kGround, picture.rgbx.begin() + n * 4);
  return picture;
}

// Each point is the mean of those that lie where it is.
image::Picture Averaged(const image::Picture& fine, int side_px) {
  image::Picture picture = image::Picture::Blank(side_px, side_px);
  const auto begin = [&](int n) { return n * fine.width_px / side_px; };
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x) {
      std::array<int, 4> sums{};
      int count = 0;
      for (int from_y = begin(y); from_y < begin(y + 1); ++from_y)
        for (int from_x = begin(x); from_x < begin(x + 1); ++from_x, ++count)
          for (std::size_t colour = 0; colour < sums.size(); ++colour)
            sums[colour] += fine.rgbx[static_cast<std::size_t>(from_y * fine.width_px + from_x) * 4 + colour];
      for (std::size_t colour = 0; colour < sums.size(); ++colour)
        At(picture, x, y)[colour] = static_cast<std::uint8_t>(sums[colour] / count);
    }
  return picture;
}

int Part(float part, int side_px) {
  return std::max(1, static_cast<int>(std::lround(part * static_cast<float>(side_px))));
}

// Of all three colours alike, so that a face stays known by them.
void Dim(image::Picture& picture) {
  for (std::uint8_t& value : picture.rgbx)
    value = static_cast<std::uint8_t>(static_cast<float>(value) * kDimmed);
}

// Along the inside of the edge, over what is there: seen from the side, too, where brightness alone tells little.
void Frame(image::Picture& picture) {
  const int side = picture.width_px, width = Part(kFrameWidth, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (std::min({x, y, side - 1 - x, side - 1 - y}) < width)
        std::ranges::copy(kFrameColour, At(picture, x, y));
}

// The pictures of one call after the other. Borrows studio and lettering.
class KeyPainter {
 public:
  KeyPainter(stage::Studio& studio, image::Lettering& lettering) : studio_(studio), lettering_(lettering) {}

  // Draws the call, for Paint. `name` is written on it.
  Result<void> Draw(const show::Call& call, const std::string& name) {
    text_ = TextOfKey(name);
    const auto scene = SceneOfKey(call, studio_.show());
    drawn_ = scene ? image::Picture::Blank(kDrawn_px, kDrawn_px) : image::Picture{};
    if (!scene) return {};
    return studio_.Draw(*scene, {kDrawn_px, kDrawn_px, ports::PixelMemory{drawn_.rgbx}});
  }

  image::Picture Paint(int side_px) {
    if (drawn_.rgbx.empty()) return Tile(text_, side_px);
    image::Picture picture = Averaged(drawn_, side_px);
    // A band below, so that the name can be read over any face, and above the frame, which would cover it.
    const int size = Part(kNameHeight, side_px), frame = Part(kFrameWidth, side_px);
    const int band = lettering_.height_px(size) + frame;
    for (int y = 0; y < band; ++y)
      for (int x = 0; x < side_px; ++x)
        for (int colour = 0; colour < 3; ++colour) At(picture, x, y)[colour] /= 4;
    Write(text_, size, frame, picture);
    return picture;
  }

 private:
  // One line, or one word in each where it is too long for that.
  image::Picture Tile(const std::string& text, int side_px) {
    image::Picture picture = Filled(side_px);
    const int size = Part(kTileTextHeight, side_px), line = lettering_.height_px(size);
    const std::size_t blank = text.find(' ');
    if (blank == std::string::npos || lettering_.width_px(text, size) <= RoomOf(side_px)) {
      Write(text, size, (side_px - line) / 2, picture);
    } else {
      Write(text.substr(0, blank), size, side_px / 2, picture);
      Write(text.substr(blank + 1), size, side_px / 2 - line, picture);
    }
    return picture;
  }

  // Between the sides of the frame.
  static int RoomOf(int side_px) { return side_px - 2 * Part(kFrameWidth, side_px); }

  // In the middle of the row that begins at `y_px`.
  void Write(const std::string& text, int size_px, int y_px, image::Picture& into) {
    const std::string fits = image::Shorten(lettering_, text, size_px, RoomOf(into.width_px));
    lettering_.Draw(fits, {.size_px = size_px}, (into.width_px - lettering_.width_px(fits, size_px)) / 2,
                    y_px, into);
  }

  stage::Studio& studio_;
  image::Lettering& lettering_;
  std::string text_;
  image::Picture drawn_;  // Empty: the call has its name alone.
};

// Hundreds of small files, which can be drawn again: they are not waited for one by one until the disk has them.
Result<void> Save(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file ? Result<void>{} : Fail(std::errc::io_error, "write " + path.string());
}

// Both states of one key.
Result<void> GiveKey(const image::Picture& picture, const decode::DeckShape& shape, std::uint64_t call,
                     const KeySink& sink) {
  for (const bool is_lit : {false, true}) {
    image::Picture state = picture;
    is_lit ? Frame(state) : Dim(state);
    auto file = KeyFile(state, shape);
    if (!file) return tl::unexpected(file.error());
    if (auto ok = sink({shape.key_px, call, is_lit, std::move(*file)}); !ok) return ok;
  }
  return {};
}

// Has no bright state: nothing is on there.
Result<void> GiveBlank(const decode::DeckShape& shape, const KeySink& sink) {
  auto file = KeyFile(image::Picture::Blank(shape.key_px, shape.key_px), shape);
  if (!file) return tl::unexpected(file.error());
  return sink({shape.key_px, 0, false, std::move(*file)});
}

}  // namespace

Result<int> DrawKeys(stage::Studio& studio, const KeySink& sink,
                     const std::function<void(std::string_view)>& step) {
  auto lettering = image::Lettering::Open();
  if (!lettering) return tl::unexpected(lettering.error());
  for (const decode::DeckShape& shape : decode::kDeckShapes)
    if (auto ok = GiveBlank(shape, sink); !ok) return tl::unexpected(ok.error());
  const roles::Items items = roles::ItemsOf(studio.show());
  KeyPainter painter(studio, *lettering);
  int drawn = 0;
  for (const std::string& name : roles::TeachableCalls(items)) {
    const auto call = roles::CallNamed(name, items);
    if (!call || call->kind == show::CallKind::kGoTo) continue;
    step(name);
    if (auto ok = painter.Draw(*call, name); !ok) return tl::unexpected(ok.error());
    const std::uint64_t sum = roles::SumOfCall(*call, studio.show().name, items);
    for (const decode::DeckShape& shape : decode::kDeckShapes)
      if (auto ok = GiveKey(painter.Paint(shape.key_px), shape, sum, sink); !ok)
        return tl::unexpected(ok.error());
    ++drawn;
  }
  return drawn;
}

// The folders are made first, so that a place where nothing can be written is known before anything is drawn.
Result<KeySink> KeyFiles(std::filesystem::path folder) {
  for (const decode::DeckShape& shape : decode::kDeckShapes) {
    const auto of_shape = folder / std::to_string(shape.key_px);
    std::error_code error;
    std::filesystem::create_directories(of_shape, error);
    if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + of_shape.string());
  }
  return [folder = std::move(folder)](const show::KeyPicture& key) {
    return Save(folder / stage::KeyFileName(key), key.file);
  };
}

}  // namespace kaori::authoring
