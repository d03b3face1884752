#include "appliance/programs/lips/lip_options.h"

#include <charconv>
#include <string_view>

#include "appliance/programs/lips/generations.h"
#include "drivers/base/number.h"
#include "drivers/base/options.h"

namespace kaori::lips {
namespace {

constexpr std::string_view kHelp =
    R"(kaori-lips: measures the operator's painted lips and voice and publishes them on the board

  --board FILE    the board, shared with the other programs
  --device NAME   the camera: /dev/video0, or libcamera:NAME for a camera of libcamera
  --modes         print the modes of the camera and the rates that would be used, and end
  --links FOLDER  the simulator's camera, microphone and loudspeaker, whose sockets are in FOLDER
  --microphone NAME   the microphone of the operator's voice: a device of ALSA, such as hw:1; "any" means the
                      first one on USB, or else the box's own
  --loudspeaker NAME  the loudspeaker, likewise; it plays the voice in time with the mouth, and the sounds of
                      motions
  --sound-delay MS    the delay of the voice: 0 to 500 milliseconds; "auto" uses the measured one; "off" uses
                      no loudspeaker; default: that of the settings, or else auto
  --pack FILE     the show, for the sounds of its motions
  --trust FILE    a public key, or a folder of them: a show that none of them has signed plays no sound
  --shows FOLDER  shows that were brought to the box: the sounds are those of the show that the stage plays
  --verified      the show lies on a root file system whose blocks the kernel verifies, so that only the
                  sounds are read
  --settings FILE the file of the calibration (paint, key, smoothing, range of the mouth); it need not exist
  --service       allow calibration: kaori-desk may connect, and the screen shows what to do
  --paint R,G,B   the paint's colour, 0 to 255 each; default: that of the settings, or else blue (20,60,200)
  --rest WIDTH    the width of the mouth at rest, in widths of the picture (0.05 to 0.95); default: that of
                  the settings, or else measured in the first second
)";

// Removes a whole number of 0 to 255, and the comma after it if one is expected, from the front of `text`.
std::optional<std::uint8_t> ParseLevel(std::string_view& text, bool comma) {
  std::uint8_t level = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (!comma) return level;
  if (text.empty() || text[0] != ',') return std::nullopt;
  text.remove_prefix(1);
  return level;
}

// Three levels of sRGB, as a colour picker shows them, and nothing behind them.
Result<Paint> ParsePaint(std::string_view text) {
  const std::string whole(text);
  const auto red = ParseLevel(text, true);
  const auto green = red ? ParseLevel(text, true) : std::nullopt;
  const auto blue = green ? ParseLevel(text, false) : std::nullopt;
  if (!blue || !text.empty())
    return FailInput("--paint " + whole + ": expected three numbers of 0 to 255, as in 20,60,200");
  return Paint{*red, *green, *blue};
}

// from_chars and no stream: the decimal point is one in every language.
Result<float> ParseRest(const std::string& text) {
  const auto rest = ParseNumber<float>(text);
  if (!rest || !(*rest >= 0.05F && *rest <= 0.95F))
    return FailInput("--rest " + text + ": expected a number of 0.05 to 0.95");
  return *rest;
}

}  // namespace

// Words alone: what --paint and --rest say is judged by SettingsOf, and other values by whoever uses them.
std::optional<int> ParseOptions(int argc, char** argv, LipOptions& into) {
  Options options(kHelp);
  options.Text("--board", into.board)
      .Text("--device", into.device)
      .Text("--links", into.links)
      .Text("--settings", into.settings)
      .Text("--paint", into.paint)
      .Text("--rest", into.rest)
      .Text("--microphone", into.microphone)
      .Text("--loudspeaker", into.loudspeaker)
      .Text("--sound-delay", into.sound_delay)
      .Text("--pack", into.pack)
      .Text("--trust", into.trust)
      .Text("--shows", into.shows)
      .Switch("--modes", into.modes)
      .Switch("--verified", into.verified)
      .Switch("--service", into.service);
  return options.Parse(argc, argv);
}

// The command line comes last: what is tried there is not saved by itself.
Result<LipSettings> SettingsOf(const LipOptions& options) {
  LipSettings lips;
  if (!options.settings.empty()) lips = SettingsFrom(options.settings);
  if (!options.paint.empty()) {
    const auto paint = ParsePaint(options.paint);
    if (!paint) return tl::unexpected(paint.error());
    lips.paint = *paint;
  }
  if (!options.rest.empty()) {
    const auto rest = ParseRest(options.rest);
    if (!rest) return tl::unexpected(rest.error());
    lips.gauge.rest_width = *rest;
  }
  return lips;
}

}  // namespace kaori::lips
