#include "appliance/programs/lips/lip_options.h"

#include <charconv>
#include <string_view>

#include "appliance/programs/lips/generations.h"
#include "drivers/base/options.h"

namespace kaori::lips {
namespace {

constexpr std::string_view kHelp =
    R"(kaori-lips: the operator's painted lips and voice, from camera and microphone to the board

  --board FILE    the board, shared with the other programs
  --device NAME   the camera: /dev/video0, or libcamera:NAME where libcamera is to bring it
  --modes         say what the camera can and which rates are chosen, and end
  --links FOLDER  the simulator's camera, microphone and loudspeaker, plugged in there
  --microphone NAME   the operator's voice: a sound device of ALSA, say hw:1; any: the first on USB, else the box's own
  --loudspeaker NAME  plays the voice when the mouth comes to light, and the sounds of motions; or any
  --sound-delay MS    how long the voice waits, 0 to 500; auto as measured; off: no loudspeaker; as the settings
                      have it, or auto, if not given
  --pack FILE     the show, for the sounds of its motions
  --trust FILE    a public key: play no sound of a show that it has not signed
  --verified      the show lies on a root whose every block the kernel checks: only its sounds are read
  --settings FILE what was calibrated: paint, key, smoothing, how far the mouth goes; it need not be there yet
  --service       people may calibrate: kaori-desk is let in, and the screen says what to do
  --paint R,G,B   the paint's colour, 0 to 255 each; as the settings have it, or blue (20,60,200), if not given
  --rest WIDTH    the mouth at rest, in widths of the picture (0.05 to 0.95); as the settings have it, or measured
                  in the first second, if not given
)";

// Takes a whole number of 0 to 255, and the comma after it if one is wanted, off the front.
std::optional<std::uint8_t> TakeLevel(std::string_view& text, bool comma) {
  std::uint8_t level = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (!comma) return level;
  if (text.empty() || text[0] != ',') return std::nullopt;
  text.remove_prefix(1);
  return level;
}

Result<Paint> ParsePaint(std::string_view text) {
  const std::string whole(text);
  const auto red = TakeLevel(text, true);
  const auto green = red ? TakeLevel(text, true) : std::nullopt;
  const auto blue = green ? TakeLevel(text, false) : std::nullopt;
  if (!blue || !text.empty())
    return FailInput("--paint " + whole + ": three numbers of 0 to 255 are wanted, as in 20,60,200");
  return Paint{*red, *green, *blue};
}

Result<float> ParseRest(const std::string& text) {
  float rest = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rest);
  if (error != std::errc{} || end != text.data() + text.size() || !(rest >= 0.05F && rest <= 0.95F))
    return FailInput("--rest " + text + ": a number of 0.05 to 0.95 is wanted");
  return rest;
}

}  // namespace

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
      .Switch("--modes", into.modes)
      .Switch("--verified", into.verified)
      .Switch("--service", into.service);
  return options.Parse(argc, argv);
}

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
