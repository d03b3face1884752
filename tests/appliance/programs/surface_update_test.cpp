// Updates from the box's side: to a surface whose firmware is the real one, on a flash whose power can be cut at any operation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "appliance/programs/surface/surface_update.h"
#include "firmware/surface/dial_box.h"
#include "firmware/surface/sha256.h"
#include "firmware/surface/slots.h"
#include "firmware/surface/updater.h"
#include "tests/appliance/core/board_file.h"
#include "tests/firmware/figures.h"
#include "tests/firmware/proof/nor.h"

namespace kaori::surface_update {
namespace {

using proof::Cut;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

constexpr std::uint32_t kBoxProduct = 0x12090001;
constexpr std::uint32_t kVersion1 = 1U << 16U;
constexpr std::uint32_t kVersion2 = 2U << 16U;

UpdateFile MakeUpdate(std::uint32_t version, std::uint32_t product = kBoxProduct) {
  UpdateFile file;
  file.bytes.resize(3000);
  for (std::size_t n = 0; n < file.bytes.size(); ++n)
    file.bytes[n] = static_cast<std::uint8_t>(n * version >> 7U);
  file.image = {
      .product = product, .length = 3000, .version = version, .sha256 = surface::Sha256Of(file.bytes)};
  return file;
}

// A dial box at a bus of one socket. Power that was cut comes back after a while.
class Box final : public ports::HidBus {
 public:
  Box() {
    const UpdateFile delivered = MakeUpdate(kVersion1);
    flash.Erase(surface::At(surface::Slot::kA));
    flash.Erase(surface::ImageAt(surface::Slot::kA));
    for (std::uint32_t at = 0; at < delivered.image.length; at += surface::kPageBytes) {
      const auto rest = std::span(delivered.bytes).subspan(at);
      flash.Program(surface::ImageAt(surface::Slot::kA) + at,
                    rest.first(std::min<std::size_t>(rest.size(), surface::kPageBytes)));
    }
    surface::WriteHeader(flash, surface::Slot::kA, {.generation = 1, .image = delivered.image});
    surface::Keep(flash, surface::Slot::kA);
    PowerOn();
  }

  // The first stage chooses and starts an image, as on the chip.
  void PowerOn() {
    flash.PowerOn();
    const auto slot = surface::Choose(flash);
    ASSERT_TRUE(slot) << "nothing is left to start";
    const auto header = surface::ReadHeader(flash, *slot);
    version = header->image.version;
    started_at_ = now;
    ++power_;
    updater_.emplace(flash,
                     surface::Running{.slot = *slot, .product = kBoxProduct, .oldest_version = kVersion1});
    firmware_.emplace(surface::Unit{.major = static_cast<std::uint16_t>(version >> 16U)}, &*updater_);
  }
  void PowerOff(Duration for_time) {
    firmware_.reset();
    back_at_ = now + for_time;
  }
  // Time passes; an image that dies is started anew by the watchdog.
  void Play(Duration step) {
    now += step;
    if (firmware_ && version == deadly_version && now - started_at_ >= deadly_after)
      PowerOff(milliseconds(100));
    if (!firmware_ && now >= back_at_) PowerOn();
  }
  bool answers() const {
    return firmware_.has_value() && !(version == deadly_version && deadly_after == Duration::zero());
  }

  int pollable() const override { return -1; }
  Result<std::vector<std::string>> Ports() override {
    return answers() ? std::vector<std::string>{"1-4.1"} : std::vector<std::string>{};
  }
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string&) override;

  proof::Nor flash;
  Time now = Time{} + std::chrono::seconds(1000);
  std::uint32_t version = 0;
  std::uint32_t deadly_version = 0;  // An image of this version dies so long after its start.
  Duration deadly_after{};

 private:
  friend class BoxChannel;
  std::optional<surface::Updater> updater_;
  std::optional<surface::DialBox> firmware_;
  int power_ = 0;
  Time started_at_{};
  Time back_at_{};
};

class BoxChannel final : public ports::HidChannel {
 public:
  explicit BoxChannel(Box& box) : box_(box), power_(box.power_) {}
  int pollable() const override { return -1; }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t>) override { return Gone(); }
  Result<void> Write(std::span<const std::uint8_t>) override { return Gone(); }
  Result<std::size_t> GetFeature(std::span<std::uint8_t> into) override {
    if (!is_there()) return Gone();
    std::array<std::uint8_t, surface::kPacketBytes> answer{};
    const std::size_t bytes = box_.firmware_->Answer(surface::ReportKind::kFeature, answer);
    std::copy_n(answer.begin(), bytes, into.begin() + 1);
    return 1 + bytes;
  }
  Result<void> SetFeature(std::span<const std::uint8_t> report) override {
    if (!is_there()) return Gone();
    const bool accepted = box_.firmware_->Accept(surface::ReportKind::kFeature, report.subspan(1));
    const bool restarts = box_.firmware_->wants_restart();
    if (restarts || !box_.flash.is_on()) {
      box_.PowerOff(milliseconds(300));
      return restarts ? Result<void>{} : Gone();
    }
    if (!accepted) return Fail(std::errc::io_error, "send a feature");
    return {};
  }

 private:
  bool is_there() const { return box_.answers() && power_ == box_.power_; }
  static tl::unexpected<Error> Gone() { return Fail(std::errc::no_such_device, "use 1-4.1"); }

  Box& box_;
  int power_;
  ports::HidIdentity identity_{
      .port = "1-4.1", .vendor = 0x1209, .product = 0x0001, .name = "box", .descriptor = {}};
};

Result<std::unique_ptr<ports::HidChannel>> Box::Open(const std::string& port) {
  if (!answers()) return Fail(std::errc::no_such_device, "open " + port);
  return std::make_unique<BoxChannel>(*this);
}

// Until it has an outcome, or two minutes are over.
void RunToItsEnd(SurfaceUpdate& update, Box& box) {
  using State = SurfaceUpdate::State;
  for (int n = 0; n < 6000 && update.state() != State::kDone && update.state() != State::kFailed; ++n) {
    update.Step(box.now);
    box.Play(milliseconds(20));
  }
}

TEST(SurfaceUpdate, ANewImageIsTriedForTenSecondsAndThenKept) {
  Box box;
  const UpdateFile file = MakeUpdate(kVersion2);
  SurfaceUpdate update(box, "1-4.1", file);
  while (update.state() != SurfaceUpdate::State::kTrying) {
    update.Step(box.now);
    box.Play(milliseconds(20));
    ASSERT_NE(update.state(), SurfaceUpdate::State::kFailed) << update.outcome();
  }
  const Time since = box.now;
  EXPECT_FALSE(surface::IsKept(box.flash, surface::Slot::kB));
  RunToItsEnd(update, box);
  EXPECT_EQ(update.outcome(), "the surface at 1-4.1 plays version 2.0");
  EXPECT_GE(box.now - since, SurfaceUpdate::kProbation);
  EXPECT_TRUE(surface::IsKept(box.flash, surface::Slot::kB));
  SurfaceUpdate again(box, "1-4.1", file);
  RunToItsEnd(again, box);
  EXPECT_EQ(again.outcome(), "the surface at 1-4.1 has version 2.0 already");
}

TEST(SurfaceUpdate, AnImageThatDoesNotStartOrDiesEarlyIsGivenUpAndTheOneBeforePlays) {
  for (const Duration dies_after :
       {Duration(0), Duration(milliseconds(50)), Duration(std::chrono::seconds(6))}) {
    Box box;
    box.deadly_version = kVersion2;
    box.deadly_after = dies_after;
    const UpdateFile file = MakeUpdate(kVersion2);
    SurfaceUpdate update(box, "1-4.1", file);
    RunToItsEnd(update, box);
    EXPECT_EQ(update.state(), SurfaceUpdate::State::kFailed);
    EXPECT_THAT(update.outcome(), HasSubstr("the new image did not start; it plays version 1.0 as before"));
    EXPECT_EQ(box.version, kVersion1);
  }
}

TEST(SurfaceUpdate, AnImageOfAnotherProductIsRefusedAndChangesNothing) {
  Box box;
  const UpdateFile file = MakeUpdate(kVersion2, 0x12090002);
  const auto operations = box.flash.operations();
  SurfaceUpdate update(box, "1-4.1", file);
  RunToItsEnd(update, box);
  EXPECT_THAT(update.outcome(), HasSubstr("was not updated: it refuses the image"));
  EXPECT_EQ(box.flash.operations(), operations);
}

TEST(SurfaceUpdate, ASurfaceThatIsNotThereIsSaidAfterAWhile) {
  Box box;
  box.PowerOff(std::chrono::hours(1));
  const UpdateFile file = MakeUpdate(kVersion2);
  SurfaceUpdate update(box, "1-4.1", file);
  RunToItsEnd(update, box);
  EXPECT_EQ(update.outcome(), "the surface at 1-4.1 was not updated: it is not there");
}

TEST(SurfaceUpdate, ACutOfThePowerAtAnyOperationLeavesASurfaceThatPlaysAndTheUpdateGoesOn) {
  const UpdateFile file = MakeUpdate(kVersion2);
  std::uint32_t cuts = 0;
  std::uint32_t dead = 0;
  for (const Cut how : {Cut::kBefore, Cut::kHalf, Cut::kAfter}) {
    for (std::uint32_t operation = 1;; ++operation) {
      Box box;
      box.flash.CutAt(operation, how, operation * 31 + static_cast<std::uint32_t>(how));
      SurfaceUpdate update(box, "1-4.1", file);
      RunToItsEnd(update, box);
      ++cuts;
      if (::testing::Test::HasFatalFailure()) return;
      // Whatever became of this one, the next finds a surface that plays, and succeeds.
      box.PowerOn();
      SurfaceUpdate next(box, "1-4.1", file);
      RunToItsEnd(next, box);
      dead += next.state() == SurfaceUpdate::State::kDone && box.version == kVersion2 ? 0U : 1U;
      EXPECT_EQ(next.state(), SurfaceUpdate::State::kDone) << operation << ": " << next.outcome();
      EXPECT_EQ(update.state(), SurfaceUpdate::State::kDone) << operation << ": " << update.outcome();
      if (operation > box.flash.operations()) break;
    }
  }
  EXPECT_GT(cuts, 50U);
  proof::Figure("box_update_cuts", cuts);
  proof::Figure("box_update_cuts_dead", dead);
}

TEST(SurfaceUpdate, OnlyInServiceAndNeverTheLastDialBoxOfARunningShow) {
  const wire::SurfaceImage box{.product = kBoxProduct}, stick{.product = 0x12090002};
  EXPECT_THAT(MayUpdate(box, {.in_service = false}).error().message(), HasSubstr("in service only"));
  const Circumstances running{.in_service = true, .show_runs = true, .dial_boxes = 1};
  EXPECT_THAT(MayUpdate(box, running).error().message(), HasSubstr("the last dial box of a running show"));
  EXPECT_TRUE(MayUpdate(stick, running));
  EXPECT_TRUE(MayUpdate(box, {.in_service = true, .show_runs = true, .dial_boxes = 2}));
  EXPECT_TRUE(MayUpdate(box, {.in_service = true, .show_runs = false, .dial_boxes = 1}));
}

TEST(UpdateFile, IsReadWholeOrNotAtAll) {
  board::BoardFile folder;
  const UpdateFile made = MakeUpdate(kVersion2);
  const auto path = folder.folder() / "box.update";
  const auto write = [&](std::size_t cut) {
    std::ofstream out(path, std::ios::binary);
    for (const std::uint8_t byte : wire::Encode(made.image)) out.put(static_cast<char>(byte));
    for (std::size_t n = 0; n + cut < made.bytes.size(); ++n) out.put(static_cast<char>(made.bytes[n]));
  };
  write(0);
  EXPECT_EQ(ReadUpdateFile(path)->image, made.image);
  EXPECT_EQ(ReadUpdateFile(path)->bytes, made.bytes);
  write(1);
  EXPECT_THAT(ReadUpdateFile(path).error().message(),
              HasSubstr("its image has 2999 bytes where its head says 3000"));
  write(3000);
  EXPECT_THAT(ReadUpdateFile(path).error().message(), HasSubstr("too short"));
}

}  // namespace
}  // namespace kaori::surface_update
