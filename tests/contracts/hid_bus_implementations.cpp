// The buses of HID devices: hidraw and libusb in a made-up kernel, the simulator's link, MIDI surfaces and a serial box at
// terminals, and dials on GPIO lines.
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>

#include "drivers/gpio/dial_bus.h"
#include "drivers/hid/hidraw_bus.h"
#include "drivers/hid/libusb_bus.h"
#include "drivers/hid/local_bus.h"
#include "drivers/midi/midi_bus.h"
#include "drivers/serial/serial_bus.h"
#include "firmware/wire/dial_box.h"
#include "firmware/wire/link_packets.h"
#include "hw-sim/links/serial/pty_port.h"
#include "tests/contracts/hid_bus_contract.h"
#include "tests/drivers/hid_mock_usb.h"
#include "tests/drivers/link_peer.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::contracts {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> DescriptorOfABox() {
  return {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()};
}

std::string MissingKernel() {
  return tests::InMockKernel() ? "" : "the library umockdev-preload could not be loaded";
}

class HidrawBusSubject final : public HidBusSubject {
 public:
  HidrawBusSubject() {
    if (!tests::InMockKernel()) return;
    kernel_ = std::make_unique<tests::MockKernel>();
    bus_ = hid::HidrawBus::Open(clock).value();
  }
  std::string missing() const override { return MissingKernel(); }
  ports::HidBus& bus() override { return *bus_; }
  std::string Plug(int n) override {
    kernel_->Plug(kPorts[At(n)], 0, Node(n), boxes_[At(n)]);
    return kPorts[At(n)];
  }
  void Unplug(int n) override {
    kernel_->Unplug(kPorts[At(n)], 0, Node(n));
    ++pulled_;
  }

 private:
  static constexpr std::array kPorts{"1-4.2", "1-3"};
  static std::size_t At(int n) { return static_cast<std::size_t>(n); }
  // The testbed keeps a node's name: what comes back has another one.
  std::string Node(int n) const { return "hidraw" + std::to_string(n + 2 * pulled_); }

  std::array<tests::MockHidraw, 2> boxes_{tests::MockHidraw(DescriptorOfABox()),
                                          tests::MockHidraw(DescriptorOfABox())};
  std::unique_ptr<tests::MockKernel> kernel_;
  std::unique_ptr<hid::HidrawBus> bus_;
  int pulled_ = 0;
};

class LibusbBusSubject final : public HidBusSubject {
 public:
  LibusbBusSubject() {
    if (!tests::InMockKernel()) return;
    kernel_ = std::make_unique<tests::MockKernel>();
    bus_ = hid::LibusbBus::Open(clock).value();
  }
  std::string missing() const override { return MissingKernel(); }
  ports::HidBus& bus() override { return *bus_; }
  int sockets() const override { return 1; }
  std::string Plug(int) override {
    box_ = std::make_unique<tests::MockUsb>(tests::MockUsb::Options{DescriptorOfABox(), true, "Dial Box"});
    box_->Plug(*kernel_);
    return "1-4";
  }
  void Unplug(int) override { box_->Unplug(*kernel_); }

 private:
  std::unique_ptr<tests::MockKernel> kernel_;
  std::unique_ptr<tests::MockUsb> box_;
  std::unique_ptr<hid::LibusbBus> bus_;
};

// Devices that say hello to whoever connects.
class LocalBusSubject final : public HidBusSubject {
 public:
  LocalBusSubject() : bus_(hid::LocalHidBus::Watch(folder_.path()).value()) {}
  ports::HidBus& bus() override { return *bus_; }
  std::string Plug(int n) override {
    peers_[At(n)].emplace(folder_.path() + "/hid." + kNames[At(n)]);
    return kNames[At(n)];
  }
  void Unplug(int n) override {
    peers_[At(n)].reset();
    fs::remove(folder_.path() + "/hid." + kNames[At(n)]);
  }
  void Pass() override {
    const auto descriptor = DescriptorOfABox();
    const auto head = wire::Encode(wire::HidHello{1, 2, 0, static_cast<std::uint16_t>(descriptor.size())});
    std::vector<std::uint8_t> hello(head.begin(), head.end());
    hello.insert(hello.end(), descriptor.begin(), descriptor.end());
    for (auto& peer : peers_)
      if (peer && peer->Accept()) peer->Send(hello);
  }

 private:
  static constexpr std::array kNames{"left", "box"};
  static std::size_t At(int n) { return static_cast<std::size_t>(n); }

  sim::TempFolder folder_;
  std::array<std::optional<tests::LinkPeer>, 2> peers_;
  std::unique_ptr<ports::HidBus> bus_;
};

// Terminals in folders that look like the kernel's.
class MidiBusSubject final : public HidBusSubject {
 public:
  MidiBusSubject() {
    for (const char* name : {"snd", "class"}) fs::create_directories(Folder() / name);
    bus_ = midi::MidiBus::Open({.nodes = Folder() / "snd",
                                .classes = Folder() / "class",
                                .look_every = std::chrono::milliseconds(1)},
                               known_, clock)
               .value();
  }
  ports::HidBus& bus() override { return *bus_; }
  bool is_told() const override { return false; }
  std::string Plug(int n) override {
    const std::string node = Node(n);
    std::string port = n == 0 ? "1-4" : "1-3";
    const fs::path usb = Folder() / "devices" / port;
    fs::create_directories(usb / node);
    std::ofstream(usb / "idVendor") << "2580\n";
    std::ofstream(usb / "idProduct") << "0007\n";
    UniqueFd& cable = cables_[static_cast<std::size_t>(n)];
    cable = UniqueFd(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    EXPECT_EQ(::unlockpt(cable.get()), 0);
    fs::create_symlink(::ptsname(cable.get()), Folder() / "snd" / node);
    fs::create_directory_symlink(usb / node, Folder() / "class" / node);
    return port;
  }
  void Unplug(int n) override {
    fs::remove(Folder() / "class" / Node(n));
    fs::remove(Folder() / "snd" / Node(n));
    cables_[static_cast<std::size_t>(n)].reset();
  }

 private:
  fs::path Folder() const { return folder_.path(); }
  static std::string Node(int n) { return "midiC" + std::to_string(n + 1) + "D0"; }

  sim::TempFolder folder_;
  std::vector<midi::KnownSurface> known_{{.name = "a surface",
                                          .vendor = 0x2580,
                                          .product = 0x0007,
                                          .map = {.dials = {}, .buttons = {}, .start = {}}}};
  std::array<UniqueFd, 2> cables_;
  std::unique_ptr<midi::MidiBus> bus_;
};

class SerialBusSubject final : public HidBusSubject {
 public:
  SerialBusSubject()
      : bus_(serial::SerialBus::Open({.path = folder_.path() + "/" + kName,
                                      .box = decode::SerialBox::kSgi,
                                      .look_every = std::chrono::milliseconds(1)},
                                     clock)
                 .value()) {}
  ports::HidBus& bus() override { return *bus_; }
  bool is_told() const override { return false; }
  int sockets() const override { return 1; }
  std::string Plug(int) override {
    EXPECT_TRUE(line_.Plug());
    return kName;
  }
  void Unplug(int) override { line_.Unplug(); }
  void Pass() override {
    clock.Advance(std::chrono::milliseconds(1));
    line_.Pump(clock.now());
  }

 private:
  static constexpr const char* kName = "dials-of-1993";
  sim::TempFolder folder_;
  sim::SerialDialBox box_{sim::SerialDialBox::Kind::kSgi};
  sim::PtyPort line_{folder_.path() + "/" + kName, box_};
  std::unique_ptr<serial::SerialBus> bus_;
};

class DialBusSubject final : public HidBusSubject {
 public:
  DialBusSubject()
      : bus_(gpio::DialBus::Open([] { return std::make_unique<RestingDials>(); }, clock).value()) {}
  ports::HidBus& bus() override { return *bus_; }
  bool is_fixed() const override { return true; }
  int sockets() const override { return 1; }
  std::string Plug(int) override { return "gpio-dials"; }
  void Unplug(int) override {}

 private:
  class RestingDials final : public gpio::DialLines {
   public:
    int pollable() const override { return -1; }
    Result<decode::DialEdge> ReadEdge() override {
      return Fail(std::errc::resource_unavailable_try_again, "read an edge of a dial");
    }
    Result<std::uint32_t> Levels() override { return 0U; }
  };
  std::unique_ptr<gpio::DialBus> bus_;
};

template <class Subject>
Implementation<HidBusSubject> Bus(const char* name) {
  return {name, [] { return std::make_unique<Subject>(); }};
}

INSTANTIATE_TEST_SUITE_P(HidBuses, HidBusContract,
                         ::testing::Values(Bus<HidrawBusSubject>("Hidraw"), Bus<LibusbBusSubject>("Libusb"),
                                           Bus<LocalBusSubject>("Local"), Bus<MidiBusSubject>("Midi"),
                                           Bus<SerialBusSubject>("Serial"), Bus<DialBusSubject>("Dials")),
                         NameOf<HidBusSubject>);

}  // namespace
}  // namespace kaori::contracts
