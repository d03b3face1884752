// kaori-lips: measures the operator's painted lips and voice and publishes them on the board.
//
// One thread and one event loop, besides threads of libcamera where such a camera is used and one for a
// moment while settings are saved. Pictures and sound never leave the program, but for small pictures that a
// paired visitor of the desk looks at.
//
// Camera, microphone and loudspeaker may each be missing, come and go: the sections on the board then say
// absent or stale. It ends with status 1 where an option has a wrong value or another kaori-lips writes the
// board, and with 2 where it is misused.
#include <cstdio>

#include "appliance/core/board/watch.h"
#include "appliance/programs/lips/lip_options.h"
#include "appliance/programs/lips/lip_reader.h"
#include "appliance/programs/lips/lip_watch.h"
#include "appliance/programs/lips/service/lip_service.h"
#include "appliance/programs/lips/sound_options.h"
#include "drivers/audio/alsa_loudspeaker.h"
#include "drivers/audio/alsa_microphone.h"
#include "drivers/audio/local_loudspeaker.h"
#include "drivers/audio/local_microphone.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/program.h"
#include "drivers/camera/local_camera.h"
#include "drivers/camera/named_camera.h"

namespace {

using namespace std::chrono_literals;
using kaori::lips::LipOptions;

constexpr kaori::Duration kTick = 25ms;  // For silence and re-opening; frames wake the program by themselves.

// For whoever sets up a box: which modes the camera has, and the rates that the reader would choose.
int PrintModes(const LipOptions& options) {
  const kaori::SteadyClock clock;
  const auto text = kaori::camera::NamedCamera(options.device, clock).ModesText();
  if (!text) return kaori::ExitWithError(text.error());
  std::fputs(text->c_str(), stdout);
  return 0;
}

// The devices that were named, or else the simulator's; without either there is no device.
kaori::voice::SoundSources SoundOf(const LipOptions& options, const kaori::Clock& clock) {
  kaori::voice::SoundSources sound;
  const std::string& links = options.links;
  if (!options.microphone.empty())
    sound.microphone = kaori::audio::AlsaMicrophoneOpener(options.microphone, {}, clock);
  else if (!links.empty())
    sound.microphone = [links] { return kaori::audio::LocalMicrophone::Open(links); };
  if (options.sound_delay == "off") return sound;
  if (!options.loudspeaker.empty())
    sound.loudspeaker = kaori::audio::AlsaLoudspeakerOpener(options.loudspeaker, {.channels = 2}, clock);
  else if (!links.empty())
    sound.loudspeaker = [links, &clock] { return kaori::audio::LocalLoudspeaker::Open(links, clock); };
  return sound;
}

// The simulator's camera. Without links it fails each time, and the lips are absent: the show goes on by
// voice or dial.
kaori::ports::CameraOpener SimulatedCamera(const LipOptions& options) {
  if (!options.links.empty())
    return [links = options.links] { return kaori::camera::LocalCamera::Open(links); };
  return [] {
    return kaori::Fail(std::errc::no_such_device,
                       "open the lip camera: neither --device nor --links was given");
  };
}

// Camera, service and voice share one thread and one loop. Settings that the service changes reach the voice
// at each tick; the camera's reader gets them at once, by Tuning.
int Play(const LipOptions& options, kaori::EventLoop& loop) {
  const auto lips = kaori::lips::SettingsOf(options);
  if (!lips) return kaori::ExitWithError(lips.error());
  auto board = kaori::board::Board::Create(options.board);
  if (!board) return kaori::ExitWithError(board.error());
  auto writer = board->AcquireWriter<kaori::board::Lips>();
  if (!writer) return kaori::ExitWithError(writer.error());
  const kaori::SteadyClock clock;
  kaori::camera::NamedCamera device(options.device, clock);
  const bool simulated = options.device.empty();
  kaori::lips::LipReader reader(simulated ? SimulatedCamera(options) : device.opener(), *board,
                                std::move(*writer), *lips, clock, simulated ? nullptr : device.tuning());
  const auto service = kaori::lips::LipService::Open(
      {.service = options.service, .file = options.settings, .now = *lips}, reader, *board, clock);
  if (!service) return kaori::ExitWithError(service.error());
  // Asked before the sounds are read, so that no change of the show between the two is missed.
  const std::string played = kaori::lips::PlayedShow(options);
  auto sound_settings = kaori::lips::SoundSettingsOf(options, *lips);
  if (!sound_settings) return kaori::ExitWithError(sound_settings.error());
  const auto voice =
      kaori::voice::VoiceService::Acquire(SoundOf(options, clock), std::move(*sound_settings), *board, clock);
  if (!voice) return kaori::ExitWithError(voice.error());
  kaori::lips::LipWatch watch(reader, loop);
  watch.Step();
  const auto tick = [&] {
    watch.Step();
    (*service)->Step();
    const auto& now = (*service)->tuning().settings().voice;
    (*voice)->Use(kaori::lips::GateOf(now), kaori::lips::DelayOf(options, now));
  };
  if (auto ok = kaori::board::Watch(*board, loop); !ok) return kaori::ExitWithError(ok.error());
  if (auto ok = (*voice)->Join(loop); !ok) return kaori::ExitWithError(ok.error());
  if (auto ok = kaori::service::FeedWatchdog(loop, clock); !ok) return kaori::ExitWithError(ok.error());
  // The sounds are another show's once the stage plays another one: started again, the program reads those.
  const auto follow = [&] {
    if (const auto now = kaori::lips::PlayedShow(options); now.empty() || now == played) return;
    kaori::Log("another show plays: its sounds are read");
    loop.Stop();
  };
  if (!options.shows.empty())
    if (auto ok = loop.Every(1s, follow); !ok) return kaori::ExitWithError(ok.error());
  if (auto ok = loop.RunEvery(kTick, tick); !ok) return kaori::ExitWithError(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-lips");
  LipOptions options;
  if (const auto status = kaori::lips::ParseOptions(argc, argv, options)) return *status;
  if (options.modes) return PrintModes(options);
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  return Play(options, *loop);
}
