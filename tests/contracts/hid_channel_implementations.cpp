// The HID channels: hidraw on a socket in place of the kernel's
// node, libusb in a made-up kernel, and the simulator's link.
#include <poll.h>
#include <sys/socket.h>

#include "drivers/base/packet_socket.h"
#include "drivers/hid/hidraw_channel.h"
#include "drivers/hid/libusb_bus.h"
#include "drivers/hid/local_bus.h"
#include "firmware/wire/dial_box.h"
#include "firmware/wire/link_packets.h"
#include "tests/contracts/hid_channel_contract.h"
#include "tests/drivers/hid_mock_usb.h"
#include "tests/drivers/link_peer.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::contracts {
namespace {

using HidBytes = HidSubject::Bytes;

HidBytes DialBoxDescriptor() {
  return {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()};
}

// A seqpacket socket keeps the borders of reports and hangs up, as a hidraw node does.
class HidrawSubject final : public HidSubject {
 public:
  HidrawSubject() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
    device_ = UniqueFd(ends[0]);
    channel_ = std::make_unique<hid::HidrawChannel>(
        UniqueFd(ends[1]),
        ports::HidIdentity{.port = "1-4.2", .name = "box", .descriptor = DialBoxDescriptor()}, clock);
  }
  ports::HidChannel& channel() override { return *channel_; }
  void Send(const HidBytes& report) override {
    EXPECT_EQ(::send(device_.get(), report.data(), report.size(), MSG_NOSIGNAL), ssize_t(report.size()));
  }
  void Unplug() override { device_.reset(); }
  HidBytes received() override {
    pollfd comes{.fd = device_.get(), .events = POLLIN, .revents = 0};
    ::poll(&comes, 1, 3000);  // Another thread sends it.
    HidBytes report(64);
    const ssize_t bytes = ::recv(device_.get(), report.data(), report.size(), 0);
    report.resize(bytes > 0 ? std::size_t(bytes) : 0);
    if (!report.empty()) report.erase(report.begin());
    return report;
  }

 private:
  UniqueFd device_;
  std::unique_ptr<hid::HidrawChannel> channel_;
};

class LibusbSubject final : public HidSubject {
 public:
  LibusbSubject() {
    if (!tests::InMockKernel()) return;
    kernel_ = std::make_unique<tests::MockKernel>();
    box_ = std::make_unique<tests::MockUsb>(tests::MockUsb::Options{DialBoxDescriptor(), true, "Dial Box"});
    box_->Plug(*kernel_);
    bus_ = hid::LibusbBus::Open(clock).value();
    channel_ = bus_->Open("1-4").value();
  }
  std::string missing() const override {
    return tests::InMockKernel() ? "" : "the library umockdev-preload could not be loaded";
  }
  ports::HidChannel& channel() override { return *channel_; }
  void Send(const HidBytes& report) override { EXPECT_TRUE(box_->Send(report)); }
  void Unplug() override { box_->Vanish(); }
  bool wakes() const override { return false; }  // The fake kernel's usbfs cannot be polled.
  HidBytes received() override { return box_->received(); }

 private:
  std::unique_ptr<tests::MockKernel> kernel_;
  std::unique_ptr<tests::MockUsb> box_;
  std::unique_ptr<hid::LibusbBus> bus_;
  std::unique_ptr<ports::HidChannel> channel_;
};

class LocalHidSubject final : public HidSubject {
 public:
  LocalHidSubject() : bus_(hid::LocalHidBus::Watch(folder_.path()).value()) {
    EXPECT_TRUE(device_.Accept());
    const HidBytes descriptor = DialBoxDescriptor();
    const auto head = wire::Encode(wire::HidHello{1, 2, 3, static_cast<std::uint16_t>(descriptor.size())});
    HidBytes hello(head.begin(), head.end());
    for (const char c : {'b', 'o', 'x'}) hello.push_back(static_cast<std::uint8_t>(c));
    hello.insert(hello.end(), descriptor.begin(), descriptor.end());
    device_.Send(hello);
    EXPECT_TRUE(bus_->Ports());
    channel_ = bus_->Open("box").value();
  }
  ports::HidChannel& channel() override { return *channel_; }
  void Send(const HidBytes& report) override {
    HidBytes packet(wire::kHidStampBytes);
    wire::PutU64(packet, 0, static_cast<std::uint64_t>(clock.now().time_since_epoch().count()));
    packet.insert(packet.end(), report.begin(), report.end());
    device_.Send(packet);
  }
  void Unplug() override { device_.HangUp(); }
  HidBytes received() override {
    HidBytes report(64);
    const auto packet = device_.Receive(report);
    report.resize(packet ? packet->bytes : 0);
    if (!report.empty()) report.erase(report.begin());
    return report;
  }

 private:
  sim::TempFolder folder_;
  tests::LinkPeer device_{folder_.path() + "/hid.box"};
  std::unique_ptr<ports::HidBus> bus_;
  std::unique_ptr<ports::HidChannel> channel_;
};

INSTANTIATE_TEST_SUITE_P(
    HidChannels, HidChannelContract,
    ::testing::Values(Implementation<HidSubject>{"Hidraw", [] { return std::make_unique<HidrawSubject>(); }},
                      Implementation<HidSubject>{"Libusb", [] { return std::make_unique<LibusbSubject>(); }},
                      Implementation<HidSubject>{"Local",
                                                 [] { return std::make_unique<LocalHidSubject>(); }}),
    NameOf<HidSubject>);

}  // namespace
}  // namespace kaori::contracts
