#include "hw-sim/rehearsal/film.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

namespace kaori::sim {
namespace {

// Raw pictures from standard input, bottom row first, to H.264 of good quality; colours as a screen has
// them (sRGB in BT.709's matrix), and the index at the front, so that a browser can begin at once.
// 4:2:0 with 8 bits is what every player shows.
std::vector<std::string> Arguments(const FilmOptions& o) {
  return {"-f",
          "rawvideo",
          "-pixel_format",
          "rgb0",
          "-video_size",
          fmt::format("{}x{}", o.width_px, o.height_px),
          "-framerate",
          fmt::format("{}", o.hz),
          "-i",
          "-",
          "-vf",
          "vflip,scale=out_color_matrix=bt709",
          "-c:v",
          "libx264",
          "-preset",
          "veryfast",
          "-crf",
          "17",
          "-pix_fmt",
          "yuv420p",
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "iec61966-2-1",
          "-movflags",
          "+faststart",
          "file:" + o.file};  // A name may hold a colon.
}

}  // namespace

// Sides must be even since the film's chroma is halved both ways (4:2:0).
Result<Film> Film::Start(const FilmOptions& options) {
  if (options.width_px < 2 || options.height_px < 2 || options.width_px % 2 != 0 ||
      options.height_px % 2 != 0)
    return FailInput(fmt::format("film {} of {}x{}: its sides must be even", options.file, options.width_px,
                                 options.height_px));
  auto ffmpeg = Ffmpeg::Start(Arguments(options), options.file);
  if (!ffmpeg) return tl::unexpected(ffmpeg.error());
  return Film(std::move(*ffmpeg));
}

}  // namespace kaori::sim
