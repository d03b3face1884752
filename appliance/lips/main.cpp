// kaori-lips: the operator's painted lips, from the camera to the board.
#include <charconv>
#include <optional>
#include <string>

#include "appliance/board/board.h"
#include "appliance/lips/lip_reader.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/camera/local_camera.h"
#include "drivers/camera/v4l2_camera.h"

namespace {

using namespace std::chrono_literals;

constexpr std::string_view kHelp = R"(kaori-lips: the operator's painted lips, from the camera to the board

  --board FILE    the board, shared with the other programs
  --device FILE   the camera, say /dev/video0
  --links FOLDER  the simulator's camera, plugged in there
  --settings FILE what was calibrated: paint, key, smoothing, how far the mouth goes
  --paint R,G,B   the paint's colour, 0 to 255 each; as the settings have it, or blue (20,60,200), if not given
  --rest WIDTH    the mouth at rest, in widths of the picture (0.05 to 0.95); as the settings have it, or measured
                  in the first second, if not given
)";

constexpr kaori::Duration kTick = 25ms;  // Silence and re-opening; frames wake by themselves.

struct Settings {
  std::string board = "/dev/shm/kaori-board";
  std::string links, device, settings, paint, rest;
};

int Complain(const kaori::Error& error) {
  kaori::Log("{}", error.message());
  return 1;
}

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

kaori::Result<kaori::lips::Paint> ParsePaint(std::string_view text) {
  const std::string whole(text);
  const auto red = TakeLevel(text, true);
  const auto green = red ? TakeLevel(text, true) : std::nullopt;
  const auto blue = green ? TakeLevel(text, false) : std::nullopt;
  if (!blue || !text.empty())
    return kaori::FailInput("--paint " + whole + ": three numbers of 0 to 255 are wanted, as in 20,60,200");
  return kaori::lips::Paint{*red, *green, *blue};
}

kaori::Result<float> ParseRest(const std::string& text) {
  float rest = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rest);
  if (error != std::errc{} || end != text.data() + text.size() || !(rest >= 0.05F && rest <= 0.95F))
    return kaori::FailInput("--rest " + text + ": a number of 0.05 to 0.95 is wanted");
  return rest;
}

// Wakes the reader when its camera speaks; another camera is another descriptor.
class LipWatch {
 public:
  LipWatch(kaori::lips::LipReader& reader, kaori::EventLoop& loop) : reader_(reader), loop_(loop) {}

  void Step() {
    reader_.Step();
    if (watched_ == reader_.pollable() && opened_ == reader_.opened()) return;
    if (watched_ >= 0) loop_.Forget(watched_);
    watched_ = reader_.pollable();
    opened_ = reader_.opened();
    if (watched_ < 0) return;
    if (auto ok = loop_.Watch(watched_, [this] { Step(); }); !ok) kaori::Log("{}", ok.error().message());
  }

 private:
  kaori::lips::LipReader& reader_;
  kaori::EventLoop& loop_;
  int watched_ = -1;
  int opened_ = 0;
};

kaori::ports::CameraOpener OpenerFor(const Settings& settings, const kaori::Clock& clock) {
  if (!settings.device.empty()) return kaori::camera::V4l2Opener(settings.device, {}, clock);
  return [links = settings.links] { return kaori::camera::LocalCamera::Open(links); };
}

// What the file says, and above it what the command line says.
kaori::Result<kaori::lips::LipSettings> LipsOf(const Settings& settings) {
  kaori::lips::LipSettings lips;
  if (!settings.settings.empty()) {
    const auto read = kaori::lips::ReadLipSettings(settings.settings);
    if (!read) return tl::unexpected(read.error());
    lips = *read;
  }
  if (!settings.paint.empty()) {
    const auto paint = ParsePaint(settings.paint);
    if (!paint) return tl::unexpected(paint.error());
    lips.paint = *paint;
  }
  if (!settings.rest.empty()) {
    const auto rest = ParseRest(settings.rest);
    if (!rest) return tl::unexpected(rest.error());
    lips.gauge.rest_width = *rest;
  }
  return lips;
}

int Play(const Settings& settings, kaori::EventLoop& loop) {
  const auto lips = LipsOf(settings);
  if (!lips) return Complain(lips.error());
  const auto board = kaori::board::Board::Create(settings.board);
  if (!board) return Complain(board.error());
  auto writer = board->TakeWriter<kaori::board::Lips>();
  if (!writer) return Complain(writer.error());
  const kaori::SteadyClock clock;
  kaori::lips::LipReader reader(OpenerFor(settings, clock), *board, std::move(*writer), *lips, clock);
  LipWatch watch(reader, loop);
  watch.Step();
  for (const auto& ok : {loop.Every(kTick, [&watch] { watch.Step(); }), loop.Run()})
    if (!ok) return Complain(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::SetLogName("kaori-lips");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board)
      .Text("--device", settings.device)
      .Text("--links", settings.links)
      .Text("--settings", settings.settings)
      .Text("--paint", settings.paint)
      .Text("--rest", settings.rest);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return Complain(loop.error());
  return Play(settings, *loop);
}
