#include "hw-sim/links/usbredir/usbredir_port.h"

#include <sys/epoll.h>

#include <algorithm>

#include "drivers/base/stream_socket.h"
#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

// A machine that starts takes seconds until its socket listens; one that runs answers at once.
constexpr Duration kCallAgain = std::chrono::milliseconds(100);
// The longest packet of an interrupt endpoint (USB 2.0, 5.7.3): each report of a device of ours fits into one.
constexpr std::size_t kInterruptBytes = 1024;
constexpr int kTransfersAtOnce = 256;  // Of one endpoint: the others have their turn.

}  // namespace

void UsbredirPort::Plug() {
  if (std::exchange(plugged_, true)) return;
  device_->PowerCycle();
  call_at_ = {};
  if (greeted_) Announce();
}

void UsbredirPort::Unplug() {
  if (!std::exchange(plugged_, false)) return;
  // Told at once, so that the machine sees the cable go even if nobody pumps afterwards.
  if (std::exchange(announced_, false)) {
    wire_->Disconnect();
    if (!wire_->Write()) HangUp();
  }
  Forget();
  device_->PowerCycle();
}

// The order matters: what the machine asked is read before devices say what is due, and all of it is written
// before the machine is waited for again.
void UsbredirPort::Pump(Time now) {
  if (!connected() && plugged_ && now >= call_at_) Call(now);
  if (!connected()) return;
  if (!wire_->Read()) return HangUp();
  if (announced_) SendDue(now);
  if (!wire_->Write()) return HangUp();
  WatchForRoom();
}

std::optional<Time> UsbredirPort::next_due(Time now) const {
  if (!connected()) return plugged_ ? std::optional(call_at_) : std::nullopt;
  // Nobody waits for the device: it would only wake the loop.
  if (!announced_ || (listened_to_.empty() && bulk_in_.empty())) return std::nullopt;
  return device_->next_due(now);
}

void UsbredirPort::Call(Time now) {
  call_at_ = now + kCallAgain;
  auto socket = ConnectToStream(path_);
  if (!socket) return;
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = socket->get();
  ::epoll_ctl(epoll_, EPOLL_CTL_ADD, socket->get(), &event);
  RedirRequests& requests = *this;
  wire_ = std::make_unique<RedirWire>(std::move(*socket), requests);
  waits_for_room_ = false;
}

void UsbredirPort::HangUp() {
  wire_.reset();  // The socket leaves the epoll set by itself.
  greeted_ = false;
  announced_ = false;
  Forget();
}

// What the machine was doing with the device is over. Requests that wait for data are not answered: the
// machine has dropped them with the device.
void UsbredirPort::Forget() {
  for (const std::uint8_t endpoint : std::exchange(listened_to_, {})) device_->HostLeft(endpoint);
  bulk_in_.clear();
  configured_ = false;
}

// The loop wakes for room only while something waits for it: an idle socket always has room.
void UsbredirPort::WatchForRoom() {
  if (wire_->has_to_write() == waits_for_room_) return;
  waits_for_room_ = !waits_for_room_;
  epoll_event event{};
  event.events = waits_for_room_ ? EPOLLIN | EPOLLOUT : EPOLLIN;
  event.data.fd = wire_->pollable();
  ::epoll_ctl(epoll_, EPOLL_CTL_MOD, wire_->pollable(), &event);
}

// A burst of one endpoint is bounded; bulk requests are as many as the machine has asked for.
void UsbredirPort::SendDue(Time now) {
  for (const std::uint8_t endpoint : listened_to_) {
    for (int n = 0; n < kTransfersAtOnce; ++n) {
      const auto data = device_->NextIn(endpoint, kInterruptBytes, now);
      if (!data) break;
      wire_->InterruptIn(endpoint, *data);
    }
  }
  while (!bulk_in_.empty() && FillFirst(now)) {
  }
}

// Devices of ours have one bulk endpoint at most: requests are filled in their order.
bool UsbredirPort::FillFirst(Time now) {
  const RedirBulk request = bulk_in_.front();
  const auto data = device_->NextIn(request.endpoint, request.length_bytes, now);
  if (!data) return false;
  bulk_in_.pop_front();
  wire_->Bulk(request, RedirStatus::kDone, *data, data->size());
  return true;
}

void UsbredirPort::Announce() {
  announced_ = true;
  wire_->Describe(device_->descriptors());
  wire_->Connect(device_->descriptors());
}

void UsbredirPort::Greeted() {
  greeted_ = true;
  if (plugged_) Announce();
}

// Configuration 0 is that of a device that was not configured yet; there is no second one. Endpoints are said
// anew before the answer, since the machine looks at them as it reads that.
void UsbredirPort::SetConfiguration(std::uint64_t id, std::uint8_t number) {
  configured_ = number == 1;
  wire_->Describe(device_->descriptors());
  wire_->ConfigurationStatus(id, number <= 1 ? RedirStatus::kDone : RedirStatus::kStalled, number);
}

void UsbredirPort::GetConfiguration(std::uint64_t id) {
  // A device that is not configured answers 0 (USB 2.0, 9.4.2).
  wire_->ConfigurationStatus(id, RedirStatus::kDone, configured_ ? 1 : 0);
}

void UsbredirPort::SetAlternate(std::uint64_t id, std::uint8_t interface, std::uint8_t number) {
  // No interface of ours has another setting than 0.
  wire_->Describe(device_->descriptors());
  wire_->AlternateStatus(id, number == 0 ? RedirStatus::kDone : RedirStatus::kStalled, interface);
}

void UsbredirPort::GetAlternate(std::uint64_t id, std::uint8_t interface) {
  wire_->AlternateStatus(id, RedirStatus::kDone, interface);
}

// The device knows best; what it leaves alone may be what every device answers alike. Nothing: the request
// stalls.
void UsbredirPort::Control(std::uint64_t id, const UsbSetup& setup, std::span<const std::uint8_t> data) {
  auto answer = announced_ ? device_->Answer(setup, data) : std::nullopt;
  if (!answer && announced_ && !device_->answers_standard())
    answer = AnswerStandard(device_->descriptors(), setup);
  wire_->Control(id, setup, answer ? RedirStatus::kDone : RedirStatus::kStalled, answer.value_or(UsbBytes{}));
}

// A machine may begin again what it has begun: the device hears of one host only.
void UsbredirPort::Listen(std::uint64_t id, std::uint8_t endpoint, bool begins) {
  const bool did = std::erase(listened_to_, endpoint) > 0;
  if (begins && announced_) listened_to_.push_back(endpoint);
  if (begins && announced_ && !did) device_->HostCame(endpoint);
  if (!begins && did) device_->HostLeft(endpoint);
  wire_->ListenStatus(id, endpoint);
}

void UsbredirPort::InterruptOut(std::uint64_t id, std::uint8_t endpoint, std::span<const std::uint8_t> data) {
  if (announced_) device_->HandleOut(endpoint, data);
  wire_->InterruptOutDone(id, endpoint, data.size());
}

// A request for data waits until the device has some; data for the device is done at once.
void UsbredirPort::Bulk(const RedirBulk& request, std::span<const std::uint8_t> data) {
  if ((request.endpoint & kFromDevice) != 0 && announced_) return bulk_in_.push_back(request);
  if (announced_) device_->HandleOut(request.endpoint, data);
  // Without a device the transfer fails, as on a cable that was just pulled.
  wire_->Bulk(request, announced_ ? RedirStatus::kDone : RedirStatus::kIoError, {}, data.size());
}

void UsbredirPort::Cancel(std::uint64_t id) {
  const auto it = std::ranges::find(bulk_in_, id, &RedirBulk::id);
  // A request that was answered already is not here, and needs no second answer.
  if (it == bulk_in_.end()) return;
  wire_->Bulk(*it, RedirStatus::kCancelled, {}, 0);
  bulk_in_.erase(it);
}

}  // namespace kaori::sim
