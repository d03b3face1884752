// The dial and button box, whole but for its chip: lines in, reports out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/surface/button_log.h"
#include "firmware/surface/buttons.h"
#include "firmware/surface/dials.h"
#include "firmware/surface/hid_function.h"
#include "firmware/surface/lamps.h"
#include "firmware/surface/service.h"
#include "firmware/wire/dial_box.h"

namespace kaori::surface {

// Look may come from an interrupt; everything else is one side.
class DialBox final : public HidFunction {
 public:
  // How often a second a board calls Look and Tick.
  static constexpr std::uint32_t kLooksPerSecond = 40'000;
  static constexpr std::uint32_t kTicksPerSecond = 4'000;

  DialBox(const Unit& unit, Updater* updater) : service_(unit, updater) {}

  void Look(DialLines lines) { dials_.Look(lines); }
  // Bit n of `closed`: button n's switch is closed. Returns which lamps' outputs are on during the next tick.
  std::uint32_t Tick(std::uint32_t closed);

  // A report may have something to say.
  bool has_news() const { return !log_.empty() || has_rest_ || dials_.steps() != told_steps_; }
  // It counts as told; nothing: there is none, or what was turned was turned back.
  std::optional<wire::DialBoxReport> NextReport();
  // How things stand, without turns.
  wire::DialBoxReport Standing() const { return {.buttons_down = log_.newest()}; }

  std::uint32_t pressed() const { return log_.newest(); }
  std::uint32_t lamps() const { return lamps_.lit(); }
  std::uint32_t double_steps() const { return dials_.double_steps(); }
  bool wants_restart() const { return service_.wants_restart(); }

  // HidFunction.
  std::size_t Answer(ReportKind kind, std::span<std::uint8_t> into) override;
  bool Accept(ReportKind kind, std::span<const std::uint8_t> report) override;
  std::size_t NextInput(std::span<std::uint8_t> into) override;
  void SetHost(Host host) override;

 private:
  // A host that comes back at once finds its lamps as they were.
  static constexpr std::uint32_t kTicksToDark = 2 * kTicksPerSecond;
  bool is_dark() const {
    return host_ == Host::kAsleep || (host_ == Host::kGone && ticks_alone_ >= kTicksToDark);
  }

  Dials dials_;
  Buttons buttons_;
  ButtonLog log_;
  Lamps lamps_;
  Service service_;
  std::array<std::uint32_t, wire::kDials> told_{};  // Positions that reports have told.
  std::uint32_t told_steps_ = 0;                    // Dials::steps() of them.
  bool has_rest_ = false;                           // A turn did not fit into the last report.
  Host host_ = Host::kGone;
  std::uint32_t ticks_alone_ = kTicksToDark;  // Since the host went; counted to kTicksToDark.
};

}  // namespace kaori::surface
