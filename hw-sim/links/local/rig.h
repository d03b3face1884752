// All simulated devices, plugged into one folder of the local link, where the programs of the box find them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/input_devices.h"
#include "hw-sim/devices/loudspeaker.h"
#include "hw-sim/devices/operator_action.h"
#include "hw-sim/devices/screen.h"
#include "hw-sim/links/local/monitor_screen.h"

namespace kaori::sim {

// How the simulated box is set up; everything else is as the devices have it.
struct RigOptions {
  std::string folder;  // Made if it is not there; what a simulator that was killed left in it is replaced.
  // Of the simulated screen's one mode.
  int screen_width_px = 960;
  int screen_height_px = 540;
  // From one vertical blank to the next: 60 Hz.
  Duration screen_period = std::chrono::nanoseconds(16'666'667);
  // Of the lip camera; even sides, up to 1920 x 1080.
  int camera_width_px = 640;
  int camera_height_px = 480;
  // From frame to frame: 30 frames/s.
  Duration camera_period = std::chrono::nanoseconds(33'333'333);
  // With a SteadyClock: pollable() also wakes when something falls due. With a
  // ManualClock whoever advances it calls Pump.
  bool wakes_by_timer = false;
};

class LinkPort;
class HidPort;

// The test's side of the whole box: each device with its verbs, all cables, and faults. One thread. Time
// comes from the clock alone: the same actions at the same times give the same bytes.
class Rig final : public DeviceRig {
 public:
  // Everything is plugged in at once. Locks the folder until the rig ends. The clock
  // outlives the rig. Errors: device_or_resource_busy (another simulator has the folder),
  // those of the folder and its sockets.
  static Result<std::unique_ptr<Rig>> Open(RigOptions options, const Clock& clock);
  ~Rig() override;

  // Accepts, receives and sends whatever is due at clock.now(): reports that wait, a camera frame, a flip.
  // Never blocks. Call it when pollable() is readable, and after actions were done or time has passed. A
  // frame that was presented before this call and after the last one is shown at a vertical blank between the
  // two, if there is one.
  void Pump();

  // An epoll descriptor of every socket, and of the timer; readable when Pump has something to do.
  int pollable() const { return epoll_.get(); }
  // When Pump is next needed though no socket speaks; Time::max() while nothing waits.
  Time next_due() const;

  DialBox& dial_box() { return devices_.dial_box; }
  StickPod& left_stick() { return devices_.left_stick; }
  StickPod& right_stick() { return devices_.right_stick; }
  StickPod& stick(DevicePort port) { return devices_.stick(port); }
  InputDevices& devices() override { return devices_; }
  Keyboard& keyboard() { return devices_.keyboard; }
  Pointer& pointer() { return devices_.pointer; }
  LipCamera& camera() { return devices_.camera; }
  Screen& screen() { return screen_; }
  // Out at first; no action plugs it.
  MonitorScreen& monitor() { return monitor_; }
  LinePanel& lines() { return devices_.lines; }
  Microphone& microphone() { return devices_.microphone; }
  Loudspeaker& loudspeaker() { return loudspeaker_; }
  const Clock& clock() const { return context_.clock; }

  // Cables. `name` is a port: dial-box, stick-left, stick-right, keyboard, camera, screen, pointer,
  // microphone, loudspeaker, lines. Plugging what is plugged, or unplugging what is not, does nothing.
  // Errors: invalid_argument (no such port), those of sockets.
  Result<void> Plug(std::string_view name);
  Result<void> Unplug(std::string_view name);
  // False for a name that is no port.
  bool plugged(std::string_view name) const;
  bool connected(std::string_view name) const;  // A program has the device open.

  // Does one action: any verb, any port. Verbs that the device does not have are ignored. What falls due
  // leaves with the next Pump. Errors: as Plug.
  Result<void> Do(const OperatorAction& action) override;

  // Who is told of the actions that change something, Plug and Unplug included; replaces the last
  // watcher. Called within the action, before the link sends anything.
  void Watch(std::function<void(const OperatorAction&)> watcher) { context_.watcher = std::move(watcher); }

  // Faults of HID devices, sent at once. Errors: invalid_argument (no HID device of that name),
  // not_connected.
  // The first bytes of a report of how things stand, as when a cable is pulled in the middle of it.
  Result<void> SendTorn(std::string_view name, std::size_t first_bytes);
  // Any bytes as a report.
  Result<void> SendRaw(std::string_view name, std::span<const std::uint8_t> report);
  // Torn, and the cable is out.
  Result<void> VanishInReport(std::string_view name, std::size_t first_bytes);

 private:
  Rig(RigOptions options, const Clock& clock);
  // Makes a port for each device and plugs it in. Errors: those of LinkPort::Plug.
  Result<void> PlugAll();
  // Null where there is no such port.
  LinkPort* port(std::string_view name) const;
  // Errors: invalid_argument (no HID device of that name).
  Result<HidPort*> hid_port(std::string_view name) const;
  // Sets the timer to next_due().
  void ArmTimer();

  RigOptions options_;
  // Passed to all devices; its watcher is whom Watch named.
  DeviceContext context_;
  InputDevices devices_;
  Screen screen_;
  MonitorScreen monitor_;
  Loudspeaker loudspeaker_;
  UniqueFd lock_;  // On the folder.
  // Of all sockets and the timer.
  UniqueFd epoll_;
  // Expires at next_due(); invalid where nobody wanted it.
  UniqueFd timer_;
  // In the order of DevicePort.
  std::array<std::unique_ptr<LinkPort>, kDevicePortCount> ports_;
};

}  // namespace kaori::sim
