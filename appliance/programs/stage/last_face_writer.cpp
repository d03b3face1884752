#include "appliance/programs/stage/last_face_writer.h"

#include <utility>

#include <fmt/format.h>

#include "appliance/core/last_face/last_face.h"
#include "drivers/base/log.h"
#include "drivers/base/whole_file.h"

namespace kaori::stage {
namespace {

constexpr std::size_t kPixel_bytes = 4;

// A binary PPM without the fourth byte of each pixel: the boot splash reads it without any library.
void MakePpm(const SmallImage& image, std::vector<std::uint8_t>& into) {
  into.clear();
  const std::string head = fmt::format("P6\n{} {}\n255\n", image.width_px, image.height_px);
  into.insert(into.end(), head.begin(), head.end());
  for (std::size_t at = 0; at + kPixel_bytes <= image.pixels.size(); at += kPixel_bytes)
    into.insert(into.end(), {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]});
}

// The layout's number, little-endian, then as many bytes of the state as are in use.
void MakeState(const board::Performance& performance, std::vector<std::uint8_t>& into) {
  into.assign(sizeof(std::uint32_t), 0);
  wire::PutU32(into, 0, performance.layout);
  into.insert(into.end(), performance.state.begin(), performance.state.begin() + performance.bytes);
}

}  // namespace

// A cause is logged when it is another one than before. `failed_` is what LastFace asks before it compares.
LastFace::Writer::Writer(LastFaceFile where)
    : where_(std::move(where)), writer_(std::chrono::milliseconds(0), [this] {
        const auto written = WriteOut();
        const std::error_code cause =
            written ? std::error_code() : std::make_error_code(written.error().cause);
        if (cause && cause != logged_) LogWarning("the last face is not kept: {}", written.error().message());
        logged_ = cause;
        failed_.store(!written, std::memory_order_release);
        return true;  // What was refused is dropped.
      }) {}

// The picture lies in `image_` already, where LastFace let it be copied: the buffers are the writer's from
// here on.
void LastFace::Writer::Write(const board::Performance& performance) {
  performance_ = performance;
  writer_.Ask();
}

// On the writer's own thread. The picture comes first and the end of the file says where
// each part lies (appliance/core/last_face/last_face.h).
Result<void> LastFace::Writer::WriteOut() {
  MakePpm(image_, picture_);
  MakeState(performance_, state_);
  const auto end = last_face::EndOf({.show = where_.show, .picture = picture_, .state = state_});
  return WriteWholeFile(where_.file, {picture_, state_, end});
}

}  // namespace kaori::stage
