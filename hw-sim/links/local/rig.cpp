#include "hw-sim/links/local/rig.h"

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/file.h>
#include <sys/timerfd.h>

#include <algorithm>
#include <filesystem>

#include "hw-sim/links/local/camera_port.h"
#include "hw-sim/links/local/hid_port.h"
#include "hw-sim/links/local/lines_port.h"
#include "hw-sim/links/local/loudspeaker_port.h"
#include "hw-sim/links/local/microphone_port.h"
#include "hw-sim/links/local/screen_port.h"

namespace kaori::sim {
namespace {

// HID devices share a kind and differ by their port; of every other kind there
// is one, whose port has its name.
std::string PathOf(const std::string& folder, DevicePort port) {
  const std::string name(PortName(port));
  const bool of_its_own_kind = port == DevicePort::kCamera || port == DevicePort::kScreen ||
                               port == DevicePort::kMicrophone || port == DevicePort::kLoudspeaker ||
                               port == DevicePort::kLines;
  return folder + "/" + (of_its_own_kind ? name : "hid") + "." + name;
}

Result<void> MakeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the link folder " + folder);
  return {};
}

// Two simulators in one folder would replace each other's sockets. The lock goes with its
// descriptor, also where the simulator is killed.
Result<UniqueFd> LockFolder(const std::string& folder) {
  UniqueFd fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!fd.valid()) return FailErrno("open the link folder " + folder);
  if (::flock(fd.get(), LOCK_EX | LOCK_NB) < 0)
    return Fail(std::errc::device_or_resource_busy,
                "plug devices into " + folder + ": another simulator does");
  return fd;
}

// Watched by the same epoll set as the sockets.
Result<UniqueFd> MakeTimer(int epoll) {
  UniqueFd timer(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC));
  if (!timer.valid()) return FailErrno("create the simulator's timer");
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = timer.get();
  if (::epoll_ctl(epoll, EPOLL_CTL_ADD, timer.get(), &event) < 0)
    return FailErrno("watch the simulator's timer");
  return timer;
}

}  // namespace

// The screen counts its vertical blanks from the opening.
Rig::Rig(RigOptions options, const Clock& clock)
    : options_(std::move(options)),
      context_{clock, {}},
      devices_(context_, {options_.camera_width_px, options_.camera_height_px, ports::PixelFormat::kYuyv}),
      screen_({options_.screen_width_px, options_.screen_height_px, options_.screen_period}, clock.now()),
      monitor_(options_.folder),
      loudspeaker_(context_) {}

// Takes the sockets away: a socket without a listener would look like a device that refuses.
Rig::~Rig() {
  for (auto& port : ports_) {
    if (port) port->Unplug();
  }
}

Result<std::unique_ptr<Rig>> Rig::Open(RigOptions options, const Clock& clock) {
  // The lock comes before the sockets: the sockets of a running simulator stay untouched.
  if (auto made = MakeFolder(options.folder); !made) return tl::unexpected(made.error());
  auto lock = LockFolder(options.folder);
  if (!lock) return tl::unexpected(lock.error());
  UniqueFd epoll(::epoll_create1(EPOLL_CLOEXEC));
  if (!epoll.valid()) return FailErrno("create the simulator's epoll set");
  const bool wakes_by_timer = options.wakes_by_timer;
  std::unique_ptr<Rig> rig(new Rig(std::move(options), clock));
  rig->lock_ = std::move(*lock);
  rig->epoll_ = std::move(epoll);
  if (wakes_by_timer) {
    auto timer = MakeTimer(rig->epoll_.get());
    if (!timer) return tl::unexpected(timer.error());
    rig->timer_ = std::move(*timer);
  }
  if (auto plugged = rig->PlugAll(); !plugged) return tl::unexpected(plugged.error());
  return rig;
}

// All cables are in at first. Every port is made here, so that none is null afterwards.
Result<void> Rig::PlugAll() {
  const auto path = [this](DevicePort port) { return PathOf(options_.folder, port); };
  const auto add = [this](DevicePort at, std::unique_ptr<LinkPort> port) {
    ports_[static_cast<std::size_t>(at)] = std::move(port);
  };
  const auto add_hid = [&](DevicePort port, HidDevice& device) {
    add(port, std::make_unique<HidPort>(path(port), epoll_.get(), device, context_.clock));
  };
  add_hid(DevicePort::kDialBox, devices_.dial_box);
  add_hid(DevicePort::kStickLeft, devices_.left_stick);
  add_hid(DevicePort::kStickRight, devices_.right_stick);
  add_hid(DevicePort::kKeyboard, devices_.keyboard);
  add_hid(DevicePort::kPointer, devices_.pointer);
  add(DevicePort::kCamera,
      std::make_unique<CameraPort>(path(DevicePort::kCamera), epoll_.get(), devices_.camera,
                                   CameraTiming{context_.clock.now(), options_.camera_period}));
  add(DevicePort::kScreen, std::make_unique<ScreenPort>(path(DevicePort::kScreen), epoll_.get(), screen_));
  add(DevicePort::kMicrophone, std::make_unique<MicrophonePort>(path(DevicePort::kMicrophone), epoll_.get(),
                                                                devices_.microphone, context_.clock));
  add(DevicePort::kLoudspeaker,
      std::make_unique<LoudspeakerPort>(path(DevicePort::kLoudspeaker), epoll_.get(), loudspeaker_,
                                        context_.clock));
  add(DevicePort::kLines,
      std::make_unique<LinesPort>(path(DevicePort::kLines), epoll_.get(), devices_.lines, context_.clock));
  for (auto& port : ports_) {
    if (auto plugged = port->Plug(); !plugged) return plugged;
  }
  return {};
}

// One time for all ports: what fell due together leaves together.
void Rig::Pump() {
  const Time now = context_.clock.now();
  for (auto& port : ports_) port->Pump(now);
  ArmTimer();
}

Time Rig::next_due() const {
  Time soonest = Time::max();
  for (const auto& port : ports_) {
    if (const auto due = port->next_due()) soonest = std::min(soonest, *due);
  }
  return soonest;
}

// Setting the timer also clears that it has expired.
void Rig::ArmTimer() {
  if (!timer_.valid()) return;
  const Time due = next_due();
  itimerspec spec{};
  if (due != Time::max()) {
    // Zero would disarm the timer (timerfd_settime(2)). What is due already expires at
    // once, since the time is absolute.
    const auto since_start = std::max(due.time_since_epoch(), Duration(1));
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since_start);
    spec.it_value = {seconds.count(), (since_start - seconds).count()};
  }
  ::timerfd_settime(timer_.get(), TFD_TIMER_ABSTIME, &spec, nullptr);
}

LinkPort* Rig::port(std::string_view name) const {
  const auto known = DevicePortNamed(name);
  return known ? ports_[static_cast<std::size_t>(*known)].get() : nullptr;
}

Result<void> Rig::Plug(std::string_view name) {
  LinkPort* const found = port(name);
  if (found == nullptr) return FailInput("no port is called " + std::string(name));
  if (found->plugged()) return {};
  // Somebody may have removed the folder while the cable was out.
  if (auto made = MakeFolder(options_.folder); !made) return made;
  if (auto plugged_in = found->Plug(); !plugged_in) return plugged_in;
  context_.Notify({*DevicePortNamed(name), Verb::kPlug, 0, 0, 0});
  return {};
}

Result<void> Rig::Unplug(std::string_view name) {
  LinkPort* const found = port(name);
  if (found == nullptr) return FailInput("no port is called " + std::string(name));
  if (!found->plugged()) return {};
  found->Unplug();
  context_.Notify({*DevicePortNamed(name), Verb::kUnplug, 0, 0, 0});
  return {};
}

// The rig owns cables and what it alone has; everything else is for the devices.
Result<void> Rig::Do(const OperatorAction& action) {
  if (action.verb == Verb::kPlug) return Plug(PortName(action.port));
  if (action.verb == Verb::kUnplug) return Unplug(PortName(action.port));
  if (action.port == DevicePort::kLoudspeaker && action.verb == Verb::kStall)
    loudspeaker_.Stall(action.index != 0);
  devices_.Do(action);
  return {};
}

bool Rig::plugged(std::string_view name) const {
  const LinkPort* const found = port(name);
  return found != nullptr && found->plugged();
}

bool Rig::connected(std::string_view name) const {
  const LinkPort* const found = port(name);
  return found != nullptr && found->connected();
}

Result<HidPort*> Rig::hid_port(std::string_view name) const {
  // A port knows its kind by its class alone; faults are for HID ports.
  auto* const found = dynamic_cast<HidPort*>(port(name));
  if (found == nullptr) return FailInput("no HID device is called " + std::string(name));
  return found;
}

Result<void> Rig::SendTorn(std::string_view name, std::size_t first_bytes) {
  const auto hid = hid_port(name);
  if (!hid) return tl::unexpected(hid.error());
  return (*hid)->SendTorn(first_bytes);
}

Result<void> Rig::SendRaw(std::string_view name, std::span<const std::uint8_t> report) {
  const auto hid = hid_port(name);
  if (!hid) return tl::unexpected(hid.error());
  return (*hid)->SendRaw(report);
}

Result<void> Rig::VanishInReport(std::string_view name, std::size_t first_bytes) {
  if (auto sent = SendTorn(name, first_bytes); !sent) return sent;
  return Unplug(name);
}

}  // namespace kaori::sim
