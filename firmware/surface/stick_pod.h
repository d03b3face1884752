// The stick pod, whole but for its chip: codes of a converter and switches in, reports out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/surface/axis.h"
#include "firmware/surface/button_log.h"
#include "firmware/surface/buttons.h"
#include "firmware/surface/flash.h"
#include "firmware/surface/hid_function.h"
#include "firmware/surface/lamps.h"
#include "firmware/surface/service.h"
#include "firmware/wire/stick_pod.h"

namespace kaori::surface {

// Its ends and centres are taught by a person, and kept in flash. One side.
class StickPod final : public HidFunction {
 public:
  // How often a second a board calls Tick.
  static constexpr std::uint32_t kTicksPerSecond = 4'000;
  enum Axis : std::uint8_t { kX, kY, kTwist, kSlider };
  static constexpr std::size_t kAxes = 4;
  // Codes of 12 bits, in the order of Axis. They grow to the right, towards the operator, clockwise and
  // upwards.
  using Codes = std::array<std::uint16_t, kAxes>;

  // Borrows both, of which either may be none: then nothing is kept, and updates are refused.
  StickPod(const Unit& unit, Updater* updater, Flash* flash);

  // Bits 0..11 of `closed`: the buttons' switches; 12..15: the hat's upper, right, lower and left one.
  void Tick(std::uint32_t closed, const Codes& codes);

  bool has_news() const { return has_moved_ || !log_.empty(); }
  // It counts as told.
  std::optional<wire::StickPodReport> NextReport();
  wire::StickPodReport Standing() const { return Report(log_.newest()); }
  bool wants_restart() const { return service_.wants_restart(); }

  // HidFunction.
  std::size_t Answer(ReportKind kind, std::span<std::uint8_t> into) override;
  bool Accept(ReportKind kind, std::span<const std::uint8_t> report) override;
  std::size_t NextInput(std::span<std::uint8_t> into) override;
  void SetHost(Host host) override;

 private:
  wire::StickPodReport Report(std::uint32_t pressed) const;
  std::int32_t Value(std::size_t axis) const;
  // The axes' values, where one has moved.
  void Follow();
  // Begins to learn the ends, or ends it. False: an axis was not moved, and all ends stay as they were.
  bool Calibrate(bool begins);

  Buttons switches_;
  ButtonLog log_;
  std::array<AxisFilter, kAxes> filters_{};
  std::array<AxisEnds, kAxes> ends_{};
  std::array<AxisGate, kAxes> gates_{};  // With the values that the next report says.
  std::optional<std::array<AxisTeacher, kAxes>> teachers_;
  bool has_moved_ = false;
  Host host_ = Host::kGone;
  Lamps lamps_;  // It has none; what asks for their brightness is not refused.
  Service service_;
  Flash* flash_;
};

}  // namespace kaori::surface
