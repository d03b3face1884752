// A disk with two slots, and updates for it: small parts, whole files.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "appliance/programs/update/installation.h"
#include "drivers/loader/systemd_boot.h"
#include "hw-sim/devices/simulated_disk.h"
#include "tests/drivers/fat_fixture.h"

namespace kaori::update {

using Bytes = std::vector<std::uint8_t>;

// A file on a stick that is pulled, or becomes another one, where the test wants it.
class SimulatedSource final : public Source {
 public:
  explicit SimulatedSource(Bytes content) : content_(std::move(content)) {}
  // From the n-th reading on: what it reads then.
  std::size_t readings_left = SIZE_MAX;
  std::optional<Bytes> then{};

  std::uint64_t bytes() const override { return content_.size(); }
  Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) override {
    if (readings_left == 0 && !then) return Fail(std::errc::io_error, "read the stick");
    if (readings_left == 0) content_ = *then;
    if (readings_left > 0 && readings_left != SIZE_MAX) --readings_left;
    if (at + into.size() > content_.size()) return Fail(std::errc::io_error, "read the stick to its end");
    std::copy_n(content_.begin() + static_cast<std::ptrdiff_t>(at), into.size(), into.begin());
    return {};
  }

 private:
  Bytes content_;
};

// Notes in memory, which remember how many events the disk had seen when they were changed.
class SimulatedNotes final : public Notes {
 public:
  explicit SimulatedNotes(const sim::SimulatedDisk* disk = nullptr) : disk_(disk) {}
  std::optional<Pending> pending{};
  std::optional<Pending> before{};
  std::optional<Pending> overwritten{};
  std::string last_try{};
  // What Reserve fails with.
  std::optional<std::errc> no_room{};
  std::optional<std::errc> fault{};
  // (events of the disk before it, whether it said from then on that an update waits)
  std::vector<std::pair<std::size_t, bool>> changes{};

  std::optional<Pending> ReadPending() const override { return pending; }
  Result<void> KeepPending(const Pending& wanted) override { return Change(wanted); }
  Result<void> ForgetPending() override { return Change(std::nullopt); }
  std::optional<Pending> ReadBefore() const override { return before; }
  Result<void> KeepBefore(const Pending& wanted) override {
    if (fault) return Fail(*fault, "keep the version before");
    before = wanted;
    return {};
  }
  Result<void> BeginOverwriting() override {
    if (before) overwritten = std::exchange(before, std::nullopt);
    return {};
  }
  Result<void> EndOverwriting() override {
    overwritten.reset();
    return {};
  }
  std::optional<Pending> ReadOverwritten() const override { return overwritten; }
  Result<void> Reserve() override {
    return no_room ? Result<void>(Fail(*no_room, "reserve room")) : Result<void>{};
  }
  std::string ReadLastTry() const override { return last_try; }
  Result<void> KeepLastTry(std::string_view text) override {
    if (fault) return Fail(*fault, "keep the last try");
    last_try = text;
    return {};
  }

 private:
  Result<void> Change(std::optional<Pending> wanted) {
    if (fault) return Fail(*fault, "keep what waits");
    pending = wanted;
    if (disk_ != nullptr) changes.emplace_back(disk_->events().size(), pending.has_value());
    return {};
  }
  const sim::SimulatedDisk* disk_;
};

// How much more than each run a release tries: KAORI_UPDATE_EFFORT, 1 where it is not set.
inline std::size_t Effort() {
  const char* effort = std::getenv("KAORI_UPDATE_EFFORT");
  return effort != nullptr ? std::max(1UL, std::strtoul(effort, nullptr, 10)) : 1;
}

// The file of an update of these unpacked parts; lengths and checksums of the manifest are filled in.
inline Bytes MakeBundle(Manifest manifest, const std::vector<Bytes>& parts, const show::SecretKey& signer) {
  Bytes payload;
  for (std::size_t n = 0; n < kParts; ++n) {
    const Bytes packed = Pack(parts.at(n)).value();
    show::Checksummer sum;
    sum.Add(parts.at(n));
    manifest.parts[n] = {
        .packed_bytes = packed.size(), .bytes = parts.at(n).size(), .checksum = sum.Finish()};
    payload.insert(payload.end(), packed.begin(), packed.end());
  }
  show::Checksummer sum;
  sum.Add(payload);
  manifest.payload = sum.Finish();
  manifest.payload_bytes = payload.size();
  const Header header = MakeHeader(manifest, signer);
  payload.insert(payload.begin(), header.begin(), header.end());
  return payload;
}

class UpdateTest : public ::testing::Test {
 protected:
  static constexpr std::uint64_t kRoot = 384 << 10U, kVerity = 64 << 10U, kKernel = 64 << 10U;
  // Where the partitions lie on the disk: boot, then root-a, verity-a, root-b, verity-b.
  static constexpr std::uint64_t kRootA = tests::FatFixture::kBytes, kVerityA = kRootA + (1U << 20U),
                                 kRootB = kVerityA + (1U << 20U), kVerityB = kRootB + (1U << 20U),
                                 kEnd = kVerityB + (1U << 20U), kKernelB = tests::FatFixture::kKernelB;
  static constexpr std::uint64_t kMiB = 1U << 20U;

  UpdateTest() {
    tests::FatFixture fat(disk_.content());
    std::fill_n(disk_.content().begin() + kRootA, kRoot, std::uint8_t{0xA1});
  }

  // Bytes that do not pack well, another row for each seed.
  static Bytes Noise(std::size_t bytes, std::uint32_t seed) {
    Bytes noise(bytes);
    for (std::uint8_t& byte : noise)
      byte = static_cast<std::uint8_t>((seed = seed * 1664525U + 1013904223U) >> 24U);
    return noise;
  }
  // The unpacked parts of a version.
  static std::vector<Bytes> PartsOf(std::uint32_t version) {
    return {Noise(kRoot, version), Noise(kVerity, version + 1000), Noise(kKernel, version + 2000),
            Noise(kKernel, version + 3000)};
  }
  static Manifest ManifestOf(std::uint32_t version) {
    return {.version = version, .from = 1, .news = "what is new"};
  }
  static Bytes BundleOf(const Manifest& manifest, const show::SecretKey& signer) {
    return MakeBundle(manifest, PartsOf(manifest.version), signer);
  }
  Bytes BundleOf(std::uint32_t version) const { return BundleOf(ManifestOf(version), maker_); }

  Progress Install(std::unique_ptr<Source> source) {
    Installation installation(std::move(source), keys_, running_,
                              {*root_b_, *verity_b_, *boot_, kKernelB, kKernel}, notes_);
    for (int steps = 0; !installation.ended() && steps < 10'000; ++steps) installation.Step();
    EXPECT_TRUE(installation.ended());
    return installation.progress();
  }
  Progress Install(const Bytes& bundle) { return Install(std::make_unique<SimulatedSource>(bundle)); }

  Bytes OnDisk(std::uint64_t at, std::uint64_t bytes) {
    const auto begin = disk_.content().begin() + static_cast<std::ptrdiff_t>(at);
    return {begin, begin + static_cast<std::ptrdiff_t>(bytes)};
  }

  const show::SecretKey maker_ = show::MakeKey().value();
  show::PublicKeys keys_{maker_.public_key()};
  Running running_{.version = 5, .least = 3, .slot = ports::Slot::kA};
  sim::SimulatedDisk disk_{kEnd};
  std::unique_ptr<ports::BlockDevice> boot_ = disk_.Partition(0, tests::FatFixture::kBytes),
                                      root_b_ = disk_.Partition(kRootB, kMiB),
                                      verity_b_ = disk_.Partition(kVerityB, kMiB);
  SimulatedNotes notes_{&disk_};
};

}  // namespace kaori::update
