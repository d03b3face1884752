// What kaori-lips plays and hears: its command line and the settings together.
#pragma once

#include "appliance/programs/lips/lip_options.h"
#include "appliance/programs/lips/lip_settings.h"
#include "appliance/programs/lips/voice/voice_seat.h"
#include "drivers/base/result.h"

namespace kaori::lips {

// Reads the show for the sounds of its motions, if one is named. Errors: a delay that is none; those of
// show::LoadSounds.
Result<voice::VoiceSeatSettings> SoundSettingsOf(const LipOptions& options, const LipSettings& lips);

// Of settings that change while the program runs. What the command line says stays.
voice::GateSettings GateOf(const VoiceSettings& voice);
voice::DelayWish DelayOf(const LipOptions& options, const VoiceSettings& voice);

}  // namespace kaori::lips
