// A box's disk and notes that lose their power at any moment: what was not flushed by then is there in part.
#pragma once

#include <algorithm>
#include <climits>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "tests/appliance/programs/update_fixture.h"

namespace kaori::update {

// Of the machine. Each thing that is kept costs one of what is left.
class Power {
 public:
  void SwitchOn(std::optional<int> goes_after) { left_ = goes_after.value_or(INT_MAX); }
  bool Spend() { return left_ > 0 && --left_ >= 0; }
  bool is_on() const { return left_ > 0; }

 private:
  int left_ = INT_MAX;
};

// A disk with a memory of its own, of which a cut leaves any part of what was not flushed, sector by sector.
class CutDisk {
 public:
  CutDisk(std::uint64_t bytes, Power& power) : disk_(bytes), power_(power) {}
  std::unique_ptr<ports::BlockDevice> Partition(std::uint64_t at, std::uint64_t bytes);
  std::vector<std::uint8_t>& content() { return disk_.content(); }
  // A control: it says that it has flushed, and has not.
  void Lie() { lies_ = true; }
  // The machine starts again: all is on the disk, or part of it where the power went.
  void Settle(std::mt19937& chance);

 private:
  class Part;
  struct Waiting {
    std::uint64_t at = 0;
    Bytes before;
  };
  sim::SimulatedDisk disk_;
  Power& power_;
  std::vector<Waiting> waiting_;
  bool lies_ = false;
};

class CutDisk::Part final : public ports::BlockDevice {
 public:
  Part(CutDisk& disk, std::uint64_t at, std::uint64_t bytes)
      : disk_(disk), at_(at), part_(disk.disk_.Partition(at, bytes)) {}
  std::uint64_t bytes() const override { return part_->bytes(); }
  Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) override { return part_->Read(at, into); }
  // Where the power goes in it, the disk has it in its memory.
  Result<void> Write(std::uint64_t at, std::span<const std::uint8_t> from) override {
    if (!disk_.power_.is_on()) return Fail(std::errc::io_error, "write a disk without power");
    const auto begin = disk_.content().begin() + static_cast<std::ptrdiff_t>(at_ + at);
    disk_.waiting_.push_back({at_ + at, Bytes(begin, begin + static_cast<std::ptrdiff_t>(from.size()))});
    auto ok = part_->Write(at, from);
    disk_.disk_.ForgetEvents();
    disk_.power_.Spend();
    if (!disk_.power_.is_on()) return Fail(std::errc::io_error, "write the disk");
    return ok;
  }
  Result<void> Flush() override {
    if (!disk_.power_.Spend()) return Fail(std::errc::io_error, "flush a disk without power");
    if (!disk_.lies_) disk_.waiting_.clear();
    return {};
  }

 private:
  CutDisk& disk_;
  std::uint64_t at_;
  std::unique_ptr<ports::BlockDevice> part_;
};

inline std::unique_ptr<ports::BlockDevice> CutDisk::Partition(std::uint64_t at, std::uint64_t bytes) {
  return std::make_unique<Part>(*this, at, bytes);
}

inline void CutDisk::Settle(std::mt19937& chance) {
  const bool was_cut = !power_.is_on();
  constexpr std::size_t kSector = 512;
  for (auto write = waiting_.rbegin(); was_cut && write != waiting_.rend(); ++write)
    for (std::size_t from = 0; from < write->before.size(); from += kSector)
      if (chance() % 2 == 0)
        std::copy_n(write->before.begin() + static_cast<std::ptrdiff_t>(from),
                    std::min(kSector, write->before.size() - from),
                    disk_.content().begin() + static_cast<std::ptrdiff_t>(write->at + from));
  waiting_.clear();
}

// Each note is kept whole or not at all, as tests of files have it.
class CutNotes final : public Notes {
 public:
  explicit CutNotes(Power& power) : power_(power) {}
  SimulatedNotes kept;

  std::optional<Pending> ReadPending() const override { return kept.ReadPending(); }
  Result<void> KeepPending(const Pending& it) override {
    return Keep([&] { return kept.KeepPending(it); });
  }
  Result<void> ForgetPending() override {
    return Keep([&] { return kept.ForgetPending(); });
  }
  std::optional<Pending> ReadBefore() const override { return kept.ReadBefore(); }
  Result<void> KeepBefore(const Pending& it) override {
    return Keep([&] { return kept.KeepBefore(it); });
  }
  Result<void> BeginOverwriting() override {
    return Keep([&] { return kept.BeginOverwriting(); });
  }
  Result<void> EndOverwriting() override {
    return Keep([&] { return kept.EndOverwriting(); });
  }
  std::optional<Pending> ReadOverwritten() const override { return kept.ReadOverwritten(); }
  std::string ReadLastTry() const override { return kept.ReadLastTry(); }
  Result<void> KeepLastTry(std::string_view it) override {
    return Keep([&] { return kept.KeepLastTry(it); });
  }
  Result<void> Reserve() override {
    return Keep([&] { return kept.Reserve(); });
  }

 private:
  template <typename Change>
  Result<void> Keep(const Change& change) {
    if (!power_.Spend()) return Fail(std::errc::io_error, "keep a note without power");
    return change();
  }
  Power& power_;
};

}  // namespace kaori::update
