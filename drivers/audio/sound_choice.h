// Which microphone and which loudspeaker, where nobody named any: the first on USB, else the box's own.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "drivers/audio/alsa_pcm.h"

namespace kaori::audio {

// A device named so on a command line is chosen here.
inline constexpr const char* kAnySound = "any";

struct SoundDevice {
  std::string name;  // As ALSA calls it: "hw:1,0".
  bool usb = false;
  bool on_screen_cable = false;  // HDMI, DisplayPort.
};

// Those of the kernel's cards that have the direction, in the order of cards. Takes a few system calls for
// each card.
std::vector<SoundDevice> ListSoundDevices(Direction direction);

// The first on USB, else the first that is no screen's, else the first. Nothing where there is none. Pure.
std::string Nearest(std::span<const SoundDevice> devices);

// A card that is silent, as many are when the kernel starts, is switched on and turned up to 0 dB; what has
// been set already stays.
void MakeAudible(const std::string& name, Direction direction);

// What the choice asks of the machine.
struct SoundSearch {
  std::function<std::vector<SoundDevice>(Direction)> list = ListSoundDevices;
  std::function<void(const std::string&, Direction)> loosen = MakeAudible;
  PcmOpener open = OpenAlsaPcm;
};

// Opens what is named; of kAnySound the nearest, and says of that one -ENODEV within two seconds after a
// nearer one came. Borrows `clock` for its life. Errors: as PcmOpener.
PcmOpener ChoosingPcmOpener(const Clock& clock, SoundSearch search = {});

}  // namespace kaori::audio
