// A box that is updated for years in simulated time: updates good and bad come in, are tried, stay and give way, people go back and
// start the other slot by hand, disks rot, and the power goes at any moment of all that.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "appliance/programs/update/trial.h"
#include "drivers/loader/systemd_boot.h"
#include "tests/appliance/programs/update_cut_disk.h"

namespace kaori::update {

// What becomes of a version where it is tried.
enum class Health { kDoesWell, kNeverStarts, kHangs, kShowsNoFace };

struct System {
  std::uint32_t version = 0;
  std::uint32_t least = 0;
  Health health = Health::kDoesWell;
};

// How often each came to pass.
struct Lived {
  int starts = 0, cuts = 0, written = 0, tries = 0, stayed = 0, gave_way = 0, went_back = 0;
  Lived& operator+=(const Lived& more) {
    starts += more.starts;
    cuts += more.cuts;
    written += more.written;
    tries += more.tries;
    stayed += more.stayed;
    gave_way += more.gave_way;
    went_back += more.went_back;
    return *this;
  }
};

class BoxOfYears {
 public:
  // What a control does wrong.
  enum class Fault { kNone, kDoesNotFlush, kKnowsNoLeast, kLooksAtNoPicture, kForgetsWhatLayThere };

  BoxOfYears(std::uint32_t seed, Fault fault) : chance_(seed), fault_(fault) {
    tests::FatFixture fat(disk_.content());
    if (fault == Fault::kDoesNotFlush) disk_.Lie();
    made_[kFirst] = {.version = kFirst, .least = 1};
    for (const ports::Slot slot : {ports::Slot::kA, ports::Slot::kB}) {
      const auto& parts = PartsOf(kFirst);
      Put(At(slot).root, parts[0]);
      Put(At(slot).verity, parts[1]);
      Put(At(slot).kernel, parts[slot == ports::Slot::kA ? 2 : 3]);
    }
  }

  const Lived& lived() const { return lived_; }
  // In words, with the start at which it was seen.
  const std::vector<std::string>& wrong() const { return wrong_; }

  // Until something is wrong.
  void Live(int starts) {
    for (int n = 0; n < starts && wrong_.empty(); ++n) Start();
  }
  // With no more cuts and with versions that do well it has such a one at last.
  void ComeToAGoodVersion() {
    is_quiet_ = true;
    const std::uint32_t wanted = newest_ + 1;
    Live(12);
    const auto system = SystemIn(ByItself());
    if (wrong_.empty() && (!system || system->version < wanted)) SayWrong("it never came to a good version");
  }

 private:
  static constexpr std::uint32_t kFirst = 5;
  static constexpr std::uint64_t kRoot = 24 << 10U, kVerity = 8 << 10U, kKernel = 16 << 10U,
                                 kRoom = 64 << 10U;
  static constexpr std::uint64_t kBoot = tests::FatFixture::kBytes;
  struct Place {
    std::uint64_t root = 0, verity = 0, kernel = 0;
  };
  static Place At(ports::Slot slot) {
    if (slot == ports::Slot::kA) return {kBoot, kBoot + kRoom, tests::FatFixture::kKernelA};
    return {kBoot + 2 * kRoom, kBoot + 3 * kRoom, tests::FatFixture::kKernelB};
  }
  // The firmware's variable is kept whole or not at all.
  class Choice final : public ports::BootChoice {
   public:
    explicit Choice(BoxOfYears& box) : box_(box), loader_(box.disk_.Partition(0, kBoot), box.running_) {}
    Result<ports::Slot> Default() override { return loader_.Default(); }
    ports::Slot running() const override { return loader_.running(); }
    Result<void> Confirm(ports::Slot slot) override { return loader_.Confirm(slot); }
    Result<void> TryOnce(ports::Slot slot) override {
      if (!box_.power_.Spend()) return Fail(std::errc::io_error, "keep a variable without power");
      if (box_.Chance(20)) return Fail(std::errc::not_supported, "keep a variable");
      box_.once_ = slot;
      return {};
    }

   private:
    BoxOfYears& box_;
    loader::SystemdBoot loader_;
  };

  bool Chance(int one_in) { return !is_quiet_ && chance_() % static_cast<unsigned>(one_in) == 0; }
  // Root, hash tree and the kernels of a version, whose number stands in front of its root.
  const std::vector<Bytes>& PartsOf(std::uint32_t version) {
    auto& parts = parts_[version];
    if (!parts.empty()) return parts;
    for (const std::uint64_t bytes : {kRoot, kVerity, kKernel, kKernel}) {
      parts.emplace_back(bytes);
      std::ranges::generate(parts.back(), [&] { return static_cast<std::uint8_t>(chance_()); });
    }
    for (std::uint32_t byte = 0; byte < 4; ++byte)
      parts[0][byte] = static_cast<std::uint8_t>(version >> 8 * byte);
    return parts;
  }
  void Put(std::uint64_t at, const Bytes& part) {
    std::ranges::copy(part, disk_.content().begin() + static_cast<std::ptrdiff_t>(at));
  }
  bool Holds(std::uint64_t at, const Bytes& part) {
    return std::equal(part.begin(), part.end(), disk_.content().begin() + static_cast<std::ptrdiff_t>(at));
  }
  // The version that lies whole in a slot; a torn one starts nothing.
  std::optional<System> SystemIn(ports::Slot slot) {
    std::uint32_t version = 0;
    for (int byte = 3; byte >= 0; --byte)
      version = version << 8U | disk_.content().at(At(slot).root + static_cast<std::uint64_t>(byte));
    const auto made = made_.find(version);
    if (made == made_.end()) return std::nullopt;
    const auto& parts = PartsOf(version);
    const bool is_whole = Holds(At(slot).kernel, parts[slot == ports::Slot::kA ? 2 : 3]) &&
                          Holds(At(slot).root, parts[0]) && Holds(At(slot).verity, parts[1]);
    return is_whole ? std::optional(made->second) : std::nullopt;
  }
  Running RunningOf(const System& system) const {
    return {system.version, fault_ == Fault::kKnowsNoLeast ? 0 : system.least, running_};
  }
  bool& IsSpoilt(ports::Slot slot) { return is_spoilt_.at(slot == ports::Slot::kB ? 1 : 0); }
  ports::Slot ByItself() {
    Choice choice(*this);
    const auto slot = choice.Default();
    if (!slot) SayWrong("loader.conf is another one");
    return slot.value_or(ports::Slot::kA);
  }
  void SayWrong(std::string_view what) { wrong_.push_back(fmt::format("start {}: {}", lived_.starts, what)); }

  void Start();
  void CheckStart(ports::Slot by_itself, const std::optional<System>& asked);
  void Run(const System& system);
  void Try(Choice& choice, const System& system);
  void Play(Choice& choice, const System& system);
  void Write(const System& system);
  void Ask(const Outcome& outcome, const System& system, std::uint32_t wanted);

  Power power_;
  CutDisk disk_{kBoot + 4 * kRoom, power_};
  CutNotes notes_{power_};
  std::mt19937 chance_;
  Fault fault_;
  show::SecretKey maker_ = show::MakeKey().value();
  std::map<std::uint32_t, System> made_;
  std::map<std::uint32_t, std::vector<Bytes>> parts_;
  std::uint32_t newest_ = kFirst;
  std::optional<ports::Slot> once_;
  ports::Slot running_ = ports::Slot::kA;
  // Of the disk: a slot whose root is spoilt plays no show, until it is written anew.
  std::array<bool, 2> is_spoilt_{};
  // What the system that asked for a try wants and knows.
  std::optional<System> asked_;
  bool is_quiet_ = false;
  Lived lived_;
  std::vector<std::string> wrong_;
};

}  // namespace kaori::update
