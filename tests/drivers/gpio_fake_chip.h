// A fake GPIO chip: a test closes its switches, sees its lamps and unplugs it.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "drivers/base/unique_fd.h"
#include "drivers/gpio/gpio_chip.h"
#include "drivers/gpio/polled_line.h"

namespace kaori::tests {

// The test's side. It must outlive the chip and its lines. Keys are the lines' offsets.
struct FakeChipState {
  bool has_interrupts = true;  // False: its inputs are polled.
  bool unplugged = false;
  int requested = 0;                          // Input lines that somebody has now.
  std::map<std::uint32_t, int> edge_sockets;  // The test's end of each input line.
  std::map<std::uint32_t, bool> levels;
  std::map<std::uint32_t, bool> lamps;

  void Switch(std::uint32_t offset, bool active, Time at) {
    levels[offset] = active;
    if (!has_interrupts) return;
    const gpio::LineEdge edge{.at = at, .active = active};
    ASSERT_EQ(::send(edge_sockets.at(offset), &edge, sizeof edge, 0), static_cast<ssize_t>(sizeof edge));
  }
  tl::unexpected<Error> Gone() const { return Fail(std::errc::no_such_device, "use an unplugged chip"); }
};

// An input line with interrupts: its edges are packets in a socket.
class FakeInput final : public gpio::InputLine {
 public:
  FakeInput(FakeChipState& chip, std::uint32_t offset) : chip_(chip), offset_(offset) {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
    line_ = UniqueFd(ends[0]);
    switch_ = UniqueFd(ends[1]);
    chip_.edge_sockets[offset] = switch_.get();
    ++chip_.requested;
  }
  ~FakeInput() override { --chip_.requested; }
  int pollable() const override { return line_.get(); }
  Result<bool> Level() override {
    if (chip_.unplugged) return chip_.Gone();
    return chip_.levels[offset_];
  }
  Result<gpio::LineEdge> ReadEdge() override {
    if (chip_.unplugged) return chip_.Gone();
    gpio::LineEdge edge;
    if (::recv(line_.get(), &edge, sizeof edge, 0) < 0) return FailErrno("read a line");
    return edge;
  }

 private:
  FakeChipState& chip_;
  std::uint32_t offset_;
  UniqueFd line_;
  UniqueFd switch_;
};

// An input line without interrupts.
class FakePlainInput final : public gpio::InputLine {
 public:
  FakePlainInput(FakeChipState& chip, std::uint32_t offset) : chip_(chip), offset_(offset) {}
  int pollable() const override { return -1; }
  Result<bool> Level() override {
    if (chip_.unplugged) return chip_.Gone();
    return chip_.levels[offset_];
  }
  Result<gpio::LineEdge> ReadEdge() override {
    return Fail(std::errc::io_error, "read an edge that nobody tells");
  }

 private:
  FakeChipState& chip_;
  std::uint32_t offset_;
};

class FakeOutput final : public gpio::OutputLine {
 public:
  FakeOutput(FakeChipState& chip, std::uint32_t offset) : chip_(chip), offset_(offset) {
    chip_.lamps[offset] = false;
  }
  Result<void> Drive(bool active) override {
    if (chip_.unplugged) return chip_.Gone();
    chip_.lamps[offset_] = active;
    return {};
  }

 private:
  FakeChipState& chip_;
  std::uint32_t offset_;
};

class FakeChip final : public gpio::GpioChip {
 public:
  FakeChip(FakeChipState& state, const Clock& clock) : state_(state), clock_(clock) {}
  Result<std::unique_ptr<gpio::InputLine>> RequestInput(const gpio::LineWiring& wiring) override {
    if (wiring.offset >= kLines) return FailInput("request a line that the chip does not have");
    if (state_.has_interrupts) return std::make_unique<FakeInput>(state_, wiring.offset);
    return gpio::PollLine(std::make_unique<FakePlainInput>(state_, wiring.offset),
                          std::chrono::milliseconds(1), clock_);
  }
  Result<std::unique_ptr<gpio::OutputLine>> RequestOutput(const gpio::LineWiring& wiring) override {
    return std::make_unique<FakeOutput>(state_, wiring.offset);
  }

 private:
  static constexpr std::uint32_t kLines = 40;
  FakeChipState& state_;
  const Clock& clock_;
};

}  // namespace kaori::tests
