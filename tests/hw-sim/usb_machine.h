// A machine's end of a usbredir cable, as small as tests need it: asks, and remembers what came.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <usbredirparser.h>

#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

struct ControlAnswer {
  std::uint8_t status = 0;
  std::uint16_t length = 0;
  UsbBytes data;
};

class UsbMachine {
 public:
  // Listens at `path`.
  explicit UsbMachine(const std::string& path);

  // Accepts who calls, takes what was sent, sends what waits. Call it, and the other end, until nothing
  // changes.
  void Step();
  void HangUp();

  // Requests; each gives its id.
  std::uint64_t Ask(const UsbSetup& setup, UsbBytes data = {});
  void Configure(std::uint8_t number);
  void SetAlternate(std::uint8_t interface, std::uint8_t number);
  void Listen(std::uint8_t endpoint);
  void StopListening(std::uint8_t endpoint);
  std::uint64_t SendInterrupt(std::uint8_t endpoint, UsbBytes data);
  std::uint64_t AskBulk(std::uint8_t endpoint, std::uint32_t bytes);
  void Cancel(std::uint64_t id);

  // What came.
  bool called() const { return parser_ != nullptr; }
  std::vector<std::string> order;  // "interfaces", "endpoints", "connect", "disconnect", as they came.
  usb_redir_interface_info_header interfaces{};
  usb_redir_ep_info_header endpoints{};
  usb_redir_device_connect_header device{};
  std::map<std::uint64_t, ControlAnswer> answers;
  std::vector<UsbBytes> reports;               // Of interrupt endpoints.
  std::vector<std::uint64_t> interrupts_done;  // OUT transfers.
  std::vector<std::pair<std::uint64_t, UsbBytes>> bulk;
  std::map<std::uint64_t, std::uint8_t> bulk_status;
  std::optional<std::uint8_t> configuration_status;
  std::optional<std::uint8_t> alternate_status;

 private:
  struct Destroy {
    void operator()(usbredirparser* parser) const { usbredirparser_destroy(parser); }
  };
  void Greet();

  UniqueFd listener_;
  UniqueFd socket_;
  std::unique_ptr<usbredirparser, Destroy> parser_;
  std::uint64_t next_id_ = 1;
};

}  // namespace kaori::sim
