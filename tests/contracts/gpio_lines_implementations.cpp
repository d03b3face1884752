// The GPIO lines: those of a fake chip with interrupts, of one without, whose lines are polled, and those on a thread. A chip
// behind a HID bridge is the kernel's, and is the same implementation as the first.
#include "drivers/gpio/background_lines.h"
#include "drivers/gpio/chip_lines.h"
#include "drivers/gpio/local_lines.h"
#include "firmware/wire/link_lines.h"
#include "tests/contracts/gpio_lines_contract.h"
#include "tests/drivers/gpio_fake_chip.h"
#include "tests/drivers/gpio_slow_lines.h"
#include "tests/drivers/link_peer.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::contracts {
namespace {

constexpr std::uint32_t kFirstInput = 7, kSecondInput = 3, kOutput = 20;

class ChipSubject final : public GpioSubject {
 public:
  explicit ChipSubject(bool has_interrupts) {
    chip_.has_interrupts = has_interrupts;
    lines_ = gpio::ChipLines::Request(std::make_unique<tests::FakeChip>(chip_, clock),
                                      {.inputs = {{.offset = kFirstInput}, {.offset = kSecondInput}},
                                       .outputs = {{.offset = kOutput}}})
                 .value();
  }
  ports::GpioLines& lines() override { return *lines_; }
  void Switch(std::uint32_t line, bool active) override {
    chip_.Switch(line == 0 ? kFirstInput : kSecondInput, active, clock.now());
  }
  bool LampBecomes(bool lit) override { return chip_.lamps.at(kOutput) == lit; }
  void Unplug() override { chip_.unplugged = true; }

 private:
  tests::FakeChipState chip_;
  std::unique_ptr<gpio::ChipLines> lines_;
};

class BackgroundSubject final : public GpioSubject {
 public:
  BackgroundSubject()
      : lines_(gpio::BackgroundLines::Begin(std::make_unique<tests::SlowLines>(chip_), 1, steady_).value()) {}
  ports::GpioLines& lines() override { return *lines_; }
  void Switch(std::uint32_t line, bool active) override { chip_.Switch(line, active, clock.now()); }
  bool LampBecomes(bool lit) override { return chip_.LampBecomes(lit); }
  void Unplug() override { chip_.Unplug(); }

 private:
  const SteadyClock steady_;
  tests::SlowChip chip_;
  std::unique_ptr<gpio::BackgroundLines> lines_;
};

class LocalLinesSubject final : public GpioSubject {
 public:
  LocalLinesSubject() : lines_(gpio::LocalLines::Connect(folder_.path(), "panel").value()) {
    EXPECT_TRUE(panel_.Accept());
    panel_.Send(wire::Encode(wire::LinesHello{.inputs = 2, .outputs = 1, .active = 0}));
    EXPECT_TRUE(lines_->Greet(std::chrono::seconds(1)));
  }
  ports::GpioLines& lines() override { return *lines_; }
  void Switch(std::uint32_t line, bool active) override {
    panel_.Send(wire::Encode(wire::LineEdge{
        .at_ns = clock.now().time_since_epoch().count(), .line = line, .active = active ? 1U : 0U}));
  }
  bool LampBecomes(bool lit) override {
    std::array<std::uint8_t, 64> packet{};
    while (const auto heard = panel_.Receive(packet))
      if (const auto drive = wire::DecodeLineDrive(std::span(packet).first(heard->bytes)))
        lit_ = drive->active != 0;
    return lit_ == lit;
  }
  void Unplug() override { panel_.HangUp(); }

 private:
  sim::TempFolder folder_;
  tests::LinkPeer panel_{folder_.path() + "/lines.panel"};
  std::unique_ptr<gpio::LocalLines> lines_;
  bool lit_ = false;
};

INSTANTIATE_TEST_SUITE_P(
    GpioChips, GpioLinesContract,
    ::testing::Values(
        Implementation<GpioSubject>{"Chip", [] { return std::make_unique<ChipSubject>(true); }},
        Implementation<GpioSubject>{"PolledChip", [] { return std::make_unique<ChipSubject>(false); }},
        Implementation<GpioSubject>{"Background", [] { return std::make_unique<BackgroundSubject>(); }},
        Implementation<GpioSubject>{"Local", [] { return std::make_unique<LocalLinesSubject>(); }}),
    NameOf<GpioSubject>);

}  // namespace
}  // namespace kaori::contracts
