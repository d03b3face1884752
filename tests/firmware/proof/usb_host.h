// A host and the cable to it, as a control surface's USB machine sees them: packets by the rules of USB 2.0, chapter 8.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "firmware/surface/usb_device.h"

namespace kaori::proof {

using Packet = std::vector<std::uint8_t>;

// The eight bytes of a SETUP.
struct Request {
  std::uint8_t type = 0;
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
  std::uint16_t length = 0;
};

// The controller. Remembers the first rule that was broken.
class Cable final : public surface::UsbPort {
 public:
  void CancelControl() override { armed_in.reset(), armed_out = stalled = false; }
  void SendControl(std::span<const std::uint8_t> packet) override {
    Rule(!armed_in, "a packet is armed while another waits");
    Rule(packet.size() <= 64, "a packet has 64 bytes at most");
    armed_in = Packet(packet.begin(), packet.end());
  }
  void ReceiveControl() override { armed_out = true; }
  void StallControl() override { stalled = true, armed_in.reset(), armed_out = false; }
  void SetAddress(std::uint8_t to) override { address = to; }
  void OpenEndpoints() override { open = true, halted_in = halted_out = false; }
  void CloseEndpoints() override { open = false, input.reset(); }
  void SetHalt(std::uint8_t endpoint, bool halted) override {
    Rule(open, "an endpoint is halted that is not open");
    (endpoint == surface::kInputEndpoint ? halted_in : halted_out) = halted;
  }
  bool IsInputFree() const override { return !input; }
  void SendInput(std::span<const std::uint8_t> report) override {
    Rule(open && !halted_in && !input, "a report is armed where none may be");
    input = Packet(report.begin(), report.end());
  }
  void Rule(bool kept, const char* rule) {
    if (!kept && broken.empty()) broken = rule;
  }

  std::optional<Packet> armed_in;
  bool armed_out = false;
  bool stalled = false;
  std::uint8_t address = 0;
  bool open = false;
  bool halted_in = false;
  bool halted_out = false;
  std::optional<Packet> input;
  std::string broken;
};

// Does whole control transfers.
class UsbHost {
 public:
  UsbHost(surface::UsbDevice& device, Cable& cable) : device_(device), cable_(cable) {}

  // The answer, empty for a transfer without one; nothing: it was stalled.
  std::optional<Packet> Control(const Request& request, const Packet& data = {}) {
    ++requests;
    device_.HandleSetup(Bytes(request));
    if ((request.type & 0x80) != 0 && request.length != 0) return Fetch(request.length);
    for (std::size_t at = 0; at < request.length && !cable_.stalled; at += 64) {
      cable_.Rule(cable_.armed_out, "the device waits for the data that it was promised");
      cable_.armed_out = false;
      const std::size_t begin = std::min(at, data.size());
      device_.HandleControlReceived(
          std::span(data).subspan(begin, std::min<std::size_t>(64, data.size() - begin)));
    }
    return Status();
  }
  std::array<std::uint8_t, 8> Bytes(const Request& request) const {
    return {request.type,
            request.request,
            static_cast<std::uint8_t>(request.value & 0xFF),
            static_cast<std::uint8_t>(request.value >> 8),
            static_cast<std::uint8_t>(request.index & 0xFF),
            static_cast<std::uint8_t>(request.index >> 8),
            static_cast<std::uint8_t>(request.length & 0xFF),
            static_cast<std::uint8_t>(request.length >> 8)};
  }
  // As a host that plugs a device in.
  void Enumerate() {
    device_.HandleReset();
    Control({0x00, 5, 7, 0, 0});
    Control({0x00, 9, 1, 0, 0});
  }
  // The report that waits at the interrupt endpoint.
  std::optional<Packet> Poll() {
    device_.Poll();
    return std::exchange(cable_.input, std::nullopt);
  }

  std::uint64_t requests = 0;

 private:
  std::optional<Packet> Status() {
    if (cable_.stalled) return std::nullopt;
    cable_.Rule(cable_.armed_in && cable_.armed_in->empty(), "an empty packet is the status of a transfer");
    cable_.armed_in.reset();
    device_.HandleControlSent();
    return Packet{};
  }
  std::optional<Packet> Fetch(std::size_t most) {
    Packet answer;
    while (!cable_.stalled) {
      cable_.Rule(cable_.armed_in.has_value(), "the device sends what it was asked for");
      if (!cable_.armed_in) return std::nullopt;
      const Packet packet = *std::exchange(cable_.armed_in, std::nullopt);
      answer.insert(answer.end(), packet.begin(), packet.end());
      device_.HandleControlSent();
      if (packet.size() == 64 && answer.size() < most) continue;
      cable_.Rule(answer.size() <= most, "no more comes than was asked for");
      cable_.Rule(cable_.armed_out && !cable_.armed_in, "the device awaits the status");
      cable_.armed_out = false;
      device_.HandleControlReceived({});
      return answer;
    }
    return std::nullopt;
  }

  surface::UsbDevice& device_;
  Cable& cable_;
};

}  // namespace kaori::proof
