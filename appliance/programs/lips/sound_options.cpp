#include "appliance/programs/lips/sound_options.h"

#include <filesystem>
#include <string>
#include <utility>

#include "appliance/core/show/pack.h"
#include "appliance/core/store/play_log.h"
#include "drivers/base/log.h"

namespace kaori::lips {
namespace {

// The gate shuts at half the amplitude at which it opens, so that it does not flutter.
constexpr float kGateHysteresis_db = 6;

// A show on the data partition, brought to the box or the copy of its own one: the stage has checked who signed it, and it is
// checked as a whole once more. Where it cannot be read the show goes on without its sounds.
std::vector<show::Sound> ClipsOnData(const std::filesystem::path& pack) {
  auto clips = show::LoadSounds(pack);
  if (clips) return std::move(*clips);
  LogWarning("{}; motions are silent", clips.error().message());
  return {};
}

// None where no show is named: motions are then silent.
Result<std::vector<show::Sound>> ClipsOf(const LipOptions& options) {
  if (options.pack.empty()) return std::vector<show::Sound>();
  if (const std::string id = PlayedShow(options); !id.empty() && id != store::kRootShow)
    return ClipsOnData(store::PackOf(id, options.shows, options.pack));
  return show::LoadOptionsOf(options.trust, options.verified).and_then([&](const show::LoadOptions& load) {
    return show::LoadSounds(options.pack, load);
  });
}

}  // namespace

std::string PlayedShow(const LipOptions& options) {
  if (options.shows.empty()) return {};
  return store::ReadPlayLog(store::PlayLogBeside(options.board)).last;
}

// The option is judged here, once: DelayOf is asked at each tick and passes over what it cannot read.
Result<voice::VoiceServiceSettings> SoundSettingsOf(const LipOptions& options, const LipSettings& lips) {
  if (!options.sound_delay.empty() && options.sound_delay != "off") {
    if (const auto delay = voice::ParseDelay(options.sound_delay); !delay)
      return tl::unexpected(delay.error());
  }
  auto clips = ClipsOf(options);
  if (!clips) return tl::unexpected(clips.error());
  return voice::VoiceServiceSettings{GateOf(lips.voice), {DelayOf(options, lips.voice), std::move(*clips)}};
}

voice::GateSettings GateOf(const VoiceSettings& voice) {
  return {.opens_db = voice.opens_db, .shuts_db = voice.opens_db - kGateHysteresis_db};
}

// The option comes before the saved setting. "off" falls through to the latter, which plays no part where
// there is no loudspeaker. Nothing stands for the measured delay.
voice::DelaySetting DelayOf(const LipOptions& options, const VoiceSettings& voice) {
  if (!options.sound_delay.empty())
    if (const auto delay = voice::ParseDelay(options.sound_delay)) return *delay;
  if (voice.sound_delay_ms < 0) return std::nullopt;
  return FromSeconds(static_cast<double>(voice.sound_delay_ms) / 1e3);
}

}  // namespace kaori::lips
