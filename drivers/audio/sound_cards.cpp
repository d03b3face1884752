// The calls of sound_choice.h that go to ALSA.
#include <alsa/asoundlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "drivers/audio/sound_choice.h"

namespace kaori::audio {
namespace {

struct CloseControl {
  void operator()(snd_ctl_t* control) const { snd_ctl_close(control); }
};
struct CloseMixer {
  void operator()(snd_mixer_t* mixer) const { snd_mixer_close(mixer); }
};

std::string CardName(int card) {
  return fmt::format("hw:{}", card);
}

// By the kernel driver's name: every card of snd-usb-audio has it,
// built-in ones of some machines included.
bool IsUsb(snd_ctl_t* control) {
  snd_ctl_card_info_t* info = nullptr;
  snd_ctl_card_info_alloca(&info);
  return snd_ctl_card_info(control, info) == 0 &&
         snd_ctl_card_info_get_driver(info) == std::string_view("USB-Audio");
}

// Appends the devices of one card that have this direction. A card that cannot be opened is left out:
// its control node may belong to nobody yet while udev sets it up.
void AddDevices(int card, snd_pcm_stream_t stream, std::vector<SoundDevice>& into) {
  snd_ctl_t* raw = nullptr;
  if (snd_ctl_open(&raw, CardName(card).c_str(), SND_CTL_NONBLOCK) < 0) return;
  const std::unique_ptr<snd_ctl_t, CloseControl> control(raw);
  const bool usb = IsUsb(raw);
  snd_pcm_info_t* info = nullptr;
  snd_pcm_info_alloca(&info);
  // Cards number their devices with gaps.
  for (int device = -1; snd_ctl_pcm_next_device(raw, &device) == 0 && device >= 0;) {
    snd_pcm_info_set_device(info, static_cast<unsigned>(device));
    snd_pcm_info_set_subdevice(info, 0);
    snd_pcm_info_set_stream(info, stream);
    if (snd_ctl_pcm_info(raw, info) < 0) continue;
    const std::string_view pcm_name(snd_pcm_info_get_name(info));
    into.push_back(
        {.name = fmt::format("hw:{},{}", card, device),
         .usb = usb,
         .on_screen_cable = pcm_name.find("HDMI") != pcm_name.npos || pcm_name.find("DP") != pcm_name.npos});
  }
}

// A mixer of the card's simple controls (snd_mixer_selem); null
// where the card has none, as many HDMI outputs.
std::unique_ptr<snd_mixer_t, CloseMixer> MixerOf(const std::string& card) {
  snd_mixer_t* raw = nullptr;
  if (snd_mixer_open(&raw, 0) < 0) return nullptr;
  std::unique_ptr<snd_mixer_t, CloseMixer> mixer(raw);
  const bool loaded = snd_mixer_attach(raw, card.c_str()) == 0 &&
                      snd_mixer_selem_register(raw, nullptr, nullptr) == 0 && snd_mixer_load(raw) == 0;
  return loaded ? std::move(mixer) : nullptr;
}

// A control that is at its lowest, or off, is what nobody set; any other volume is somebody's choice.
void UnmuteCapture(snd_mixer_elem_t* element) {
  long least = 0, most = 0, now = 0;
  if (snd_mixer_selem_has_capture_switch(element) != 0) snd_mixer_selem_set_capture_switch_all(element, 1);
  if (snd_mixer_selem_get_capture_volume_range(element, &least, &most) < 0 ||
      snd_mixer_selem_get_capture_volume(element, SND_MIXER_SCHN_FRONT_LEFT, &now) < 0 || now > least)
    return;
  // Cards without a scale in decibels get their highest volume.
  if (snd_mixer_selem_set_capture_dB_all(element, 0, -1) < 0)
    snd_mixer_selem_set_capture_volume_all(element, most);
}

// A volume that somebody set above the least stays as it is. One at the least goes to 0 dB, or to the most
// where the mixer knows no decibels.
void UnmutePlayback(snd_mixer_elem_t* element) {
  long least = 0, most = 0, now = 0;
  if (snd_mixer_selem_has_playback_switch(element) != 0) snd_mixer_selem_set_playback_switch_all(element, 1);
  if (snd_mixer_selem_get_playback_volume_range(element, &least, &most) < 0 ||
      snd_mixer_selem_get_playback_volume(element, SND_MIXER_SCHN_FRONT_LEFT, &now) < 0 || now > least)
    return;
  if (snd_mixer_selem_set_playback_dB_all(element, 0, -1) < 0)
    snd_mixer_selem_set_playback_volume_all(element, most);
}

// Playback controls on the way to the connectors. Not "Mic":
// as a playback control it plays the microphone directly.
bool IsOutput(std::string_view element) {
  constexpr std::array<std::string_view, 7> kNames{"Master",    "PCM",      "Front",       "Speaker",
                                                   "Headphone", "Line Out", "Headphone+LO"};
  return std::ranges::find(kNames, element) != kNames.end();
}

}  // namespace

std::vector<SoundDevice> ListSoundDevices(Direction direction) {
  const auto stream = direction == Direction::kCapture ? SND_PCM_STREAM_CAPTURE : SND_PCM_STREAM_PLAYBACK;
  std::vector<SoundDevice> devices;
  // The kernel numbers cards with gaps, too.
  for (int card = -1; snd_card_next(&card) == 0 && card >= 0;) AddDevices(card, stream, devices);
  return devices;
}

void MakeAudible(const std::string& name, Direction direction) {
  const auto mixer = MixerOf(name.substr(0, name.find(',')));
  if (!mixer) return;
  for (auto* element = snd_mixer_first_elem(mixer.get()); element != nullptr;
       element = snd_mixer_elem_next(element)) {
    if (snd_mixer_selem_is_active(element) == 0) continue;
    if (direction == Direction::kCapture) UnmuteCapture(element);
    if (direction == Direction::kPlayback && IsOutput(snd_mixer_selem_get_name(element)))
      UnmutePlayback(element);
  }
}

}  // namespace kaori::audio
