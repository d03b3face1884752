// Every write of one whole update is recorded, and each point of it is judged: what a power cut there, in any order of
// what was not flushed, can leave of the disk.
#include <gmock/gmock.h>

#include <fmt/format.h>

#include "appliance/programs/update/trial.h"
#include "drivers/loader/boot_partition.h"
#include "hw-sim/devices/boot_loader.h"
#include "tests/appliance/programs/update_fixture.h"

namespace kaori::update {
namespace {

using tests::FatFixture;

// A disk whose flush is left out.
class Unflushed final : public ports::BlockDevice {
 public:
  explicit Unflushed(ports::BlockDevice& device) : device_(device) {}
  std::uint64_t bytes() const override { return device_.bytes(); }
  Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) override {
    return device_.Read(at, into);
  }
  Result<void> Write(std::uint64_t at, std::span<const std::uint8_t> from) override {
    return device_.Write(at, from);
  }
  Result<void> Flush() override { return {}; }

 private:
  ports::BlockDevice& device_;
};

class UpdatePowerCut : public UpdateTest {
 protected:
  // One whole update: it comes in, is tried and stays.
  void UpdateWholly(std::unique_ptr<Source> source) {
    Install(std::move(source));
    ConfirmSlotB();
  }
  void ConfirmSlotB() {
    loader::SystemdBoot choice(disk_.Partition(0, FatFixture::kBytes), ports::Slot::kB);
    EXPECT_TRUE(choice.Confirm(ports::Slot::kB));
  }

  static bool Within(std::uint64_t at, std::uint64_t begin, std::uint64_t bytes) {
    return at >= begin && at < begin + bytes;
  }
  static bool IsOfSlotB(std::uint64_t at) {
    return Within(at, kRootB, kMiB) || Within(at, kVerityB, kMiB) ||
           Within(at, FatFixture::kKernelB, loader::kKernel_bytes);
  }

  // Whether what has been flushed by now is this version, and nothing of it still waits for a flush.
  bool IsWholeOnDisk(std::uint32_t version) const {
    const auto parts = PartsOf(version);
    const auto holds = [&](std::uint64_t at, const Bytes& part) {
      return std::equal(part.begin(), part.end(), flushed_.begin() + static_cast<std::ptrdiff_t>(at));
    };
    return waiting_.empty() && holds(kRootB, parts[0]) && holds(kVerityB, parts[1]) &&
           holds(kKernelB, parts[3]);
  }

  // A control must find something; the report counts those that do not.
  void ExpectFound(const Bytes& before, std::uint32_t version) {
    int points = 0;
    const auto faults = Judge(before, version, points);
    EXPECT_THAT(faults, ::testing::Not(::testing::IsEmpty()));
    RecordProperty("control_found", static_cast<int>(faults.size()));
  }

  // The faults of the recorded log, by the sentences of the design; `points` counts sectors, at each of which the power
  // may go. `before` is the disk before the update.
  std::vector<std::string> Judge(Bytes before, std::uint32_t version, int& points) {
    flushed_ = std::move(before);
    waiting_.clear();
    const Bytes a_settings = SettingsOf('a'), b_settings = SettingsOf('b');
    std::vector<std::string> faults;
    auto note = notes_.changes.begin();
    bool waits = false;
    const auto follow_notes = [&](std::size_t event) {
      for (; note != notes_.changes.end() && note->first <= event; ++note) {
        waits = note->second;
        if (waits && !IsWholeOnDisk(version))
          faults.push_back(fmt::format("event {}: it waits and is not whole", event));
      }
    };
    for (std::size_t n = 0; n < disk_.events().size(); ++n) {
      follow_notes(n);
      const auto& [at, content] = disk_.events()[n];
      if (content.empty()) Flush();
      for (std::uint64_t sector = at; sector < at + content.size(); sector += 512, ++points) {
        if (IsOfSlotB(sector) && !waits) continue;
        const bool is_settings = at == FatFixture::kSettings && content.size() == 512;
        if (!is_settings) faults.push_back(fmt::format("event {}: a write at {}", n, sector));
        if (is_settings && content != a_settings && content != b_settings)
          faults.push_back(fmt::format("event {}: other settings", n));
        if (is_settings && content == b_settings && !IsWholeOnDisk(version))
          faults.push_back(fmt::format("event {}: slot B is confirmed and not whole", n));
      }
      if (!content.empty()) waiting_.push_back(disk_.events()[n]);
    }
    follow_notes(disk_.events().size());
    return faults;
  }

  Bytes SettingsOf(char slot) {
    Bytes settings = OnDisk(FatFixture::kSettings, 512);
    settings[34] = static_cast<std::uint8_t>(slot);
    return settings;
  }

 private:
  void Flush() {
    for (const auto& [at, content] : waiting_)
      std::ranges::copy(content, flushed_.begin() + static_cast<std::ptrdiff_t>(at));
    waiting_.clear();
  }
  Bytes flushed_;
  std::vector<sim::DiskEvent> waiting_;
};

// Bytes that differ from `before` in a range of the disk.
int Changed(const Bytes& before, const Bytes& now, std::uint64_t begin, std::uint64_t end) {
  int changed = 0;
  for (std::uint64_t at = begin; at < end; ++at) changed += before[at] != now[at] ? 1 : 0;
  return changed;
}

TEST_F(UpdatePowerCut, AtAnyPointLeavesTheSlotThatRanAndConfirmsOnlyAWholeOne) {
  const Bytes before = disk_.content();
  UpdateWholly(std::make_unique<SimulatedSource>(BundleOf(6)));
  int points = 0;
  const auto faults = Judge(before, 6, points);
  EXPECT_THAT(faults, ::testing::IsEmpty());
  EXPECT_GE(points, 1000);
  const auto changed = [&](std::uint64_t begin, std::uint64_t end) {
    return Changed(before, disk_.content(), begin, end);
  };
  const int of_a = changed(FatFixture::kKernelA, FatFixture::kKernelB) + changed(kRootA, kRootB);
  const int of_tables =
      changed(0, FatFixture::kKernelA) + changed(FatFixture::kSettings + 512, FatFixture::kBytes);
  EXPECT_EQ(of_a, 0);
  EXPECT_EQ(of_tables, 0);
  RecordProperty("log_points", points);
  RecordProperty("log_points_wrong", static_cast<int>(faults.size()));
  RecordProperty("good_slot_bytes_changed", of_a);
  RecordProperty("fat_sectors_written", (of_tables + 511) / 512);
  EXPECT_EQ(OnDisk(FatFixture::kSettings, 512), SettingsOf('b')) << "it went to its end";
}

TEST_F(UpdatePowerCut, WouldConfirmATornSlotWithoutAFlush) {
  const Bytes before = disk_.content();
  Unflushed root(*root_b_), verity(*verity_b_), boot(*boot_);
  Installation installation(std::make_unique<SimulatedSource>(BundleOf(6)), keys_, running_,
                            {root, verity, boot, kKernelB, kKernel}, notes_);
  while (!installation.ended()) installation.Step();
  ConfirmSlotB();
  ExpectFound(before, 6);
}

TEST_F(UpdatePowerCut, WouldStartAnEmptySlotThatIsConfirmedFirst) {
  const Bytes before = disk_.content();
  ConfirmSlotB();
  Install(BundleOf(6));
  ExpectFound(before, 6);
}

// An installer that copies what comes, as dd does.
TEST_F(UpdatePowerCut, WouldWriteAnAlteredUpdateThatIsNotReadFirst) {
  const Bytes before = disk_.content();
  Bytes altered = BundleOf(6);
  altered[kHeader_bytes + 1000] ^= 1U;
  const Manifest manifest = ReadHeader(altered, altered.size()).value();
  Bytes unpacked(kRoot);
  std::span<const std::uint8_t> packed = std::span(altered).subspan(kHeader_bytes);
  static_cast<void>(Unpacker().Unpack(packed, unpacked));
  ASSERT_TRUE(root_b_->Write(0, unpacked));
  ASSERT_TRUE(root_b_->Flush());
  ASSERT_TRUE(notes_.KeepPending({manifest.version, ports::Slot::kB, 0}));
  ExpectFound(before, 6);
}

TEST_F(UpdatePowerCut, WouldBeFoundWhereTheSlotThatRunsIsWritten) {
  const Bytes before = disk_.content();
  const auto root_a = disk_.Partition(kRootA, kMiB);
  Installation installation(std::make_unique<SimulatedSource>(BundleOf(6)), keys_, running_,
                            {*root_a, *verity_b_, *boot_, kKernelB, kKernel}, notes_);
  while (!installation.ended()) installation.Step();
  ExpectFound(before, 6);
}

// As firmware does it that counts tries in the names of files.
TEST_F(UpdatePowerCut, WouldBeFoundWhereAFileIsRenamed) {
  const Bytes before = disk_.content();
  Install(BundleOf(6));
  ASSERT_TRUE(boot_->Write(FatFixture::EntryAt(4, 1), Bytes{'K', 'A', 'O', 'R', 'I', '-', 'C', ' '}));
  ConfirmSlotB();
  ExpectFound(before, 6);
}

// An installer without a least version writes what is known to have a hole; the judge knows the box's floor.
TEST_F(UpdatePowerCut, WouldWriteAVersionWithAHoleWithoutAFloor) {
  const auto is_below = [this](const std::optional<Pending>& waits) {
    return waits && waits->version < running_.least;
  };
  Install(BundleOf(2));
  EXPECT_FALSE(is_below(notes_.pending));
  const Running with_floor = running_;
  running_ = {.version = 1, .least = 0, .slot = ports::Slot::kA};
  Install(BundleOf(2));
  running_ = with_floor;
  EXPECT_TRUE(is_below(notes_.pending));
  RecordProperty("control_found", is_below(notes_.pending) ? 1 : 0);
}

// The power goes before each thing that is kept in turn. Each start of the machine then is one of the two whole slots, and
// what was tried was counted.
TEST_F(UpdatePowerCut, BetweenTheNoteAndTheTryCostsATryAtMost) {
  for (const bool is_cut_before_variable : {true, false}) {
    sim::BootLoader choice;
    SimulatedNotes notes;
    notes.pending = Pending{6, ports::Slot::kB, 0};
    choice.CallBeforeTry([&] { EXPECT_EQ(notes.pending->tries, 1U) << "counted before it is made"; });
    BeginTry(choice, notes, 5);
    if (is_cut_before_variable) choice.SwitchOn();
    EXPECT_EQ(choice.SwitchOn(), is_cut_before_variable ? ports::Slot::kA : ports::Slot::kB);
    EXPECT_EQ(choice.SwitchOn(), ports::Slot::kA) << "the next start is the one before again";
  }
}

}  // namespace
}  // namespace kaori::update
