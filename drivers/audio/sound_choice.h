// Chooses the microphone and the loudspeaker where nobody named any: the first on USB, else the box's own.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "drivers/audio/alsa_pcm.h"

namespace kaori::audio {

// The name, on a command line and in a profile, of the nearest device.
inline constexpr const char* kAnySound = "any";

// A capture or playback device of a sound card.
struct SoundDevice {
  std::string name;  // As ALSA calls it: "hw:1,0".
  // On USB: somebody has plugged it in for this box.
  bool usb = false;
  bool on_screen_cable = false;  // HDMI, DisplayPort.
};

// The devices of all cards that have this direction, in the order of cards. Opens each card's control
// node, which blocks for up to some milliseconds. A card that does not answer is left out.
std::vector<SoundDevice> ListSoundDevices(Direction direction);

// The name of the first device on USB, else of the first that is not a screen's, else of the first.
// Empty where there is none. A microphone that somebody plugged in is meant to be used; a screen's sound
// output is the last resort, since many screens have no loudspeaker. Pure.
std::string Nearest(std::span<const SoundDevice> devices);

// Unmutes the card of the device `name` and turns its volume up to 0 dB, if it is at its lowest, as
// many are when the kernel starts. Other volumes stay. Of playback only the controls on the way to the
// connectors are touched. A card without a mixer needs nothing.
void MakeAudible(const std::string& name, Direction direction);

// The calls by which a device is chosen: the machine's, or a test's.
struct SoundSearch {
  std::function<std::vector<SoundDevice>(Direction)> list = ListSoundDevices;
  std::function<void(const std::string&, Direction)> make_audible = MakeAudible;
  PcmOpener open = OpenAlsaPcm;
};

// An opener that opens the device of this name, or for kAnySound the nearest one that lets itself be opened: one
// that refused is not asked again until a device comes or goes, or all have refused. That one
// fails with -ENODEV within two seconds after a nearer one was plugged in, or after it was
// itself pulled, so that its user opens it anew. Each choice is logged. `clock` must outlive
// the opener and its devices. Errors: those of PcmOpener.
PcmOpener ChoosingPcmOpener(const Clock& clock, SoundSearch search = {});

}  // namespace kaori::audio
