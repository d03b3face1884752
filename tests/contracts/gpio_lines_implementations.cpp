// The GPIO lines: those of a fake chip with interrupts, and of one without, whose lines are polled. A chip
// behind a HID bridge is the kernel's, and is the same implementation as the first.
#include "drivers/gpio/chip_lines.h"
#include "tests/contracts/gpio_lines_contract.h"
#include "tests/drivers/gpio_fake_chip.h"

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
  bool lamp() const override { return chip_.lamps.at(kOutput); }
  void Unplug() override { chip_.unplugged = true; }

 private:
  tests::FakeChipState chip_;
  std::unique_ptr<gpio::ChipLines> lines_;
};

INSTANTIATE_TEST_SUITE_P(
    GpioChips, GpioLinesContract,
    ::testing::Values(Implementation<GpioSubject>{"Chip", [] { return std::make_unique<ChipSubject>(true); }},
                      Implementation<GpioSubject>{"PolledChip",
                                                  [] { return std::make_unique<ChipSubject>(false); }}),
    NameOf<GpioSubject>);

}  // namespace
}  // namespace kaori::contracts
