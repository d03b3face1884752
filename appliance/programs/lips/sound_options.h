// What kaori-lips plays and records, from its command line and the settings together.
#pragma once

#include <string>

#include "appliance/programs/lips/lip_options.h"
#include "appliance/programs/lips/lip_settings.h"
#include "appliance/programs/lips/voice/voice_service.h"
#include "drivers/base/result.h"

namespace kaori::lips {

// Reads the sounds of motions from the show, if one is named; blocks for the disk. Errors:
//   invalid_argument  --sound-delay is no delay
// and those of show::LoadOptionsOf and show::LoadSounds. A show that cannot be read is an error, and not
// silence: the box would be found mute in the middle of an evening.
Result<voice::VoiceServiceSettings> SoundSettingsOf(const LipOptions& options, const LipSettings& lips);

// The show that the stage plays, as it notes beside the board: an id of the store, store::kRootShow or store::kCopiedShow; empty
// without --shows. Blocks for a file in memory.
std::string PlayedShow(const LipOptions& options);

// The gate and the delay for settings that change while the program runs. A delay of the command line has
// priority. Pure.
voice::GateSettings GateOf(const VoiceSettings& voice);
voice::DelaySetting DelayOf(const LipOptions& options, const VoiceSettings& voice);

}  // namespace kaori::lips
