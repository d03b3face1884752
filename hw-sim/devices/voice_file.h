// A simulated voice in a WAV file, for programs that play or hear files; and whether a voice is heard in one.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::sim {

// Says a, i, u, e, o, again and again, a third of a second each, at the voice synth's rate and louder
// than one speaks. The same length gives the same samples.
std::vector<std::int16_t> SayVowels(Duration length);

// Writes 16 bits, one channel, at the voice synth's rate; blocks for the disk. Errors:
// those of the file (WriteWholeFile).
Result<void> WriteWav(const std::string& path, std::span<const std::int16_t> samples);

// The first channel of such a file, or of one with more channels; what was written of it so far,
// whatever its head says of the length: a program that is still recording has not filled it in. Errors:
// those of the file, invalid_argument (not 16 bits at that rate).
Result<std::vector<std::int16_t>> ReadWav(const std::string& path);

// How well the middle tenth of a second of `said` fits the best position in `heard`: 1 exactly, about 0 not
// at all. Louder or softer makes no difference, nor does a sign that is turned round: it is the cosine of the
// angle between both, as vectors of samples. Every position is tried, so the time grows with the length of
// `heard`.
double Likeness(std::span<const std::int16_t> said, std::span<const std::int16_t> heard);

}  // namespace kaori::sim
