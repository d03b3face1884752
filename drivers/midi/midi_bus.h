// MIDI surfaces of the kernel's raw MIDI, as a bus of HID devices.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/decode/midi_surface.h"
#include "drivers/ports/hid_channel.h"
#include "drivers/ports/midi_tap.h"

namespace kaori::midi {

// A surface that somebody has written a map for.
struct KnownSurface {
  std::string name;
  std::uint16_t vendor = 0;  // USB ids.
  std::uint16_t product = 0;
  decode::MidiMap map;
};

// Where the kernel says what there is; tests have folders of their own.
struct MidiFolders {
  std::filesystem::path nodes = "/dev/snd";
  std::filesystem::path classes = "/sys/class/sound";
  Duration look_every = std::chrono::milliseconds(250);
};

// As ports::HidBus, with the port names of HidrawBus. The first MIDI port of a USB device is looked for now
// and then, so that surfaces may come and go. One without a map is listed from its first note or control on,
// which is lost: until then it may be the socket of a sound card into which nobody has plugged anything.
class MidiBus final : public ports::HidBus {
 public:
  // Borrows the clock, the surfaces, which may grow no more, and the tap, which hears what all devices send;
  // null: nobody listens. Errors: those of timerfd_create(2).
  static Result<std::unique_ptr<MidiBus>> Open(MidiFolders folders, const std::vector<KnownSurface>& surfaces,
                                               const Clock& clock, ports::MidiTap* tap = nullptr);

  int pollable() const override { return timer_.get(); }
  Result<std::vector<std::string>> Ports() override;
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) override;

 private:
  struct Node {
    std::filesystem::path path;
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
  };
  // Of one without a map.
  struct Listened {
    UniqueFd node;
    decode::MidiParser parser;
    bool has_spoken = false;
  };
  const KnownSurface* MapFor(const Node& node) const;
  // Whether it has spoken until now.
  bool Listen(Listened& listened, const Node& node) const;
  MidiBus(MidiFolders folders, const std::vector<KnownSurface>& surfaces, const Clock& clock,
          ports::MidiTap* tap, UniqueFd timer)
      : folders_(std::move(folders)),
        surfaces_(surfaces),
        clock_(clock),
        tap_(tap),
        timer_(std::move(timer)) {}

  MidiFolders folders_;
  const std::vector<KnownSurface>& surfaces_;
  const Clock& clock_;
  ports::MidiTap* tap_;
  UniqueFd timer_;
  std::map<std::string, Node> nodes_;  // By port, as is the next one.
  std::map<std::string, Listened> listened_;
};

}  // namespace kaori::midi
