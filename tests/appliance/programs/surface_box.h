// A dial box with its real firmware at a bus of one socket, on a flash whose power can be cut at any operation.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "appliance/programs/surface/surface_update.h"
#include "firmware/surface/dial_box.h"
#include "firmware/surface/refusal.h"
#include "firmware/surface/sha256.h"
#include "firmware/surface/slots.h"
#include "firmware/surface/updater.h"
#include "tests/firmware/proof/nor.h"

namespace kaori::surface_update {

inline constexpr std::uint32_t kBoxProduct = 0x12090001;
inline constexpr std::uint32_t kVersion1 = 1U << 16U;
inline constexpr std::uint32_t kVersion2 = 2U << 16U;

inline UpdateFile MakeUpdate(std::uint32_t version, std::uint32_t product = kBoxProduct) {
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
      PowerOff(std::chrono::milliseconds(100));
    if (!firmware_ && now >= back_at_) PowerOn();
  }
  bool refuses() const { return version == refusing_version; }
  bool answers() const {
    return firmware_.has_value() && !(version == deadly_version && deadly_after == Duration::zero());
  }

  // What its lamps show at one tick.
  std::uint32_t lamps_now() { return firmware_->Tick(0); }

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
  bool confirms = true;                // Otherwise kKeep is refused.
  std::uint32_t refusing_version = 0;  // An image of this version finds its chip too old.

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
    surface::Refusal refusal(
        {.major = static_cast<std::uint16_t>(box_.version >> 16U), .stepping = wire::ChipStepping::kB1});
    surface::HidFunction& firmware =
        box_.refuses() ? static_cast<surface::HidFunction&>(refusal) : *box_.firmware_;
    const std::size_t bytes = firmware.Answer(surface::ReportKind::kFeature, answer);
    std::copy_n(answer.begin(), bytes, into.begin() + 1);
    return 1 + bytes;
  }
  Result<void> SetFeature(std::span<const std::uint8_t> report) override {
    if (!is_there()) return Gone();
    const bool is_keep = report[1] == static_cast<std::uint8_t>(wire::SurfaceOperation::kKeep);
    if (is_keep && !box_.confirms) return Fail(std::errc::io_error, "send a feature");
    const bool accepted = box_.firmware_->Accept(surface::ReportKind::kFeature, report.subspan(1));
    const bool restarts = box_.firmware_->wants_restart();
    if (restarts || !box_.flash.is_on()) {
      box_.PowerOff(std::chrono::milliseconds(300));
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

inline Result<std::unique_ptr<ports::HidChannel>> Box::Open(const std::string& port) {
  if (!answers()) return Fail(std::errc::no_such_device, "open " + port);
  return std::make_unique<BoxChannel>(*this);
}

}  // namespace kaori::surface_update
