// The displays beside the show: a screen of a fake graphics card, and the simulator's monitor in its file.
#include "drivers/scanout/kms_screen.h"
#include "drivers/scanout/local_screen.h"
#include "hw-sim/links/local/rig.h"
#include "tests/contracts/side_display_contract.h"
#include "tests/drivers/scanout_fake_card.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::contracts {
namespace {

class KmsDisplaySubject final : public SideDisplaySubject {
 public:
  KmsDisplaySubject() {
    card_.PlugIn(0);
    card_.PlugIn(1, {tests::ModeOf(320, 200)});
    preferences_.status_connector = "HDMI-A-2";
    const auto make = [this](int, int) -> Result<std::unique_ptr<scanout::KmsSurface>> {
      return std::make_unique<tests::FakeSurface>(card_, 10);
    };
    screen_ = scanout::KmsScreen::Open(card_, make, clock, preferences_).value();
  }
  ports::SideDisplay& display() override { return *screen_->status_display(); }
  void Blank() override {
    clock.Advance(std::chrono::milliseconds(16));
    card_.Blank(clock.now());
  }
  // The card's rows begin at the top, with padding behind each; a pixel is B, G, R, X there.
  std::array<std::uint8_t, 3> Seen(int x_px, int y_px) override {
    const auto& bytes = card_.dumb_buffers.begin()->second;
    const std::size_t pitch = bytes.size() / 200;
    const std::size_t at = static_cast<std::size_t>(199 - y_px) * pitch + 4 * static_cast<std::size_t>(x_px);
    return {bytes[at + 2], bytes[at + 1], bytes[at]};
  }

 private:
  tests::FakeCard card_{2, 2};
  scanout::KmsPreferences preferences_;
  std::unique_ptr<scanout::KmsScreen> screen_;
};

class LocalMonitorSubject final : public SideDisplaySubject {
 public:
  LocalMonitorSubject() {
    sim::RigOptions options{.folder = folder_.path(), .screen_width_px = 640, .screen_height_px = 480};
    rig_ = sim::Rig::Open(std::move(options), clock).value();
    EXPECT_TRUE(rig_->monitor().Plug());
    screen_ = scanout::LocalScreen::Open(folder_.path()).value();
    rig_->Pump();
  }
  ports::SideDisplay& display() override { return *screen_->monitor_display(); }
  std::array<std::uint8_t, 3> Seen(int x_px, int y_px) override {
    if (const auto* const picture = rig_->monitor().Read()) seen_ = *picture;
    const std::size_t at =
        4 * (static_cast<std::size_t>(y_px) * sim::MonitorScreen::kWidth_px + static_cast<std::size_t>(x_px));
    return {seen_.at(at), seen_.at(at + 1), seen_.at(at + 2)};
  }

 private:
  sim::TempFolder folder_;
  std::unique_ptr<sim::Rig> rig_;
  std::unique_ptr<ports::Scanout> screen_;
  std::vector<std::uint8_t> seen_;
};

INSTANTIATE_TEST_SUITE_P(
    SideDisplays, SideDisplayContract,
    ::testing::Values(
        Implementation<SideDisplaySubject>{"Kms", [] { return std::make_unique<KmsDisplaySubject>(); }},
        Implementation<SideDisplaySubject>{"Local", [] { return std::make_unique<LocalMonitorSubject>(); }}),
    NameOf<SideDisplaySubject>);

}  // namespace
}  // namespace kaori::contracts
