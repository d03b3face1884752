// The screens: KMS on a fake graphics card, and the simulator's screen on its link.
#include "drivers/scanout/kms_screen.h"
#include "drivers/scanout/local_screen.h"
#include "hw-sim/links/local/rig.h"
#include "tests/contracts/scanout_contract.h"
#include "tests/drivers/scanout_fake_card.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::contracts {
namespace {

class KmsSubject final : public ScanoutSubject {
 public:
  KmsSubject() {
    card_.PlugIn(0);
    const auto make = [this](int, int) -> Result<std::unique_ptr<scanout::KmsSurface>> {
      return std::make_unique<tests::FakeSurface>(card_, 10);
    };
    screen_ = scanout::KmsScreen::Open(card_, make, clock, preferences_).value();
  }
  ports::Scanout& screen() override { return *screen_; }
  void Blank() override {
    clock.Advance(std::chrono::milliseconds(16));
    card_.Blank(clock.now());
  }
  void Unplug() override { card_.Pull(0); }
  void PlugInAgain() override { card_.PlugIn(0); }
  bool wakes() const override { return false; }

 private:
  tests::FakeCard card_{1, 1};
  scanout::KmsPreferences preferences_;
  std::unique_ptr<scanout::KmsScreen> screen_;
};

class LocalScreenSubject final : public ScanoutSubject {
 public:
  LocalScreenSubject() {
    sim::RigOptions options{.folder = folder_.path(), .screen_width_px = 640, .screen_height_px = 480};
    rig_ = sim::Rig::Open(std::move(options), clock).value();
    screen_ = scanout::LocalScreen::Open(folder_.path()).value();
    rig_->Pump();
  }
  ports::Scanout& screen() override { return *screen_; }
  void Blank() override {
    rig_->Pump();
    clock.Advance(std::chrono::milliseconds(17));
    rig_->Pump();
  }
  void Unplug() override { EXPECT_TRUE(rig_->Unplug("screen")); }
  void PlugInAgain() override {
    EXPECT_TRUE(rig_->Plug("screen"));
    rig_->Pump();
  }

 private:
  sim::TempFolder folder_;
  std::unique_ptr<sim::Rig> rig_;
  std::unique_ptr<ports::Scanout> screen_;
};

INSTANTIATE_TEST_SUITE_P(
    Screens, ScanoutContract,
    ::testing::Values(Implementation<ScanoutSubject>{"Kms", [] { return std::make_unique<KmsSubject>(); }},
                      Implementation<ScanoutSubject>{"Local",
                                                     [] { return std::make_unique<LocalScreenSubject>(); }}),
    NameOf<ScanoutSubject>);

}  // namespace
}  // namespace kaori::contracts
