// Reads a WAV file as a sound of the box: 48 kHz, 16 bit.
#pragma once

#include <filesystem>

#include "appliance/core/show/show.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// PCM of 16 or 24 bit, one or two channels, 8 to 192 kHz; other rates than 48 kHz are resampled, through a
// low pass. At most 512 MB are read. Time grows with the sound's length: a fraction of a second for a
// minute of it.
//
// Errors:
//   those of ReadFile
//   invalid_argument  no WAV file, another kind of sound, no sound in it, or longer than a motion may be: the
//                     attempt names the file and the reason
Result<show::Sound> ReadWave(const std::filesystem::path& file);

}  // namespace kaori::authoring
