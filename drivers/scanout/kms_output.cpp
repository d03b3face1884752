#include "drivers/scanout/kms_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace kaori::scanout {
namespace {

// Who drives whom: for each CRTC the connector that it drives, by its place in the list. Kuhn's algorithm: a
// connector may push another one on to a CRTC that is free.
class Wiring {
 public:
  Wiring(const std::vector<KmsConnector>& connectors, std::uint32_t usable)
      : connectors_(connectors), usable_(usable) {}

  void Wire(std::size_t connector) {
    tried_ = 0;
    Find(connector);
  }

  // The CRTC of the connector, by its place in the card's order.
  std::optional<std::size_t> CrtcOf(std::size_t connector) const {
    const auto found = std::ranges::find(driven_, std::optional(connector));
    if (found == driven_.end()) return std::nullopt;
    return std::size_t(found - driven_.begin());
  }

 private:
  // One that is free is taken first: the others keep theirs.
  bool Find(std::size_t connector) {
    for (const bool push : {false, true}) {
      for (std::size_t crtc = 0; crtc < driven_.size(); ++crtc) {
        if ((connectors_[connector].crtcs & usable_ & ~tried_) >> crtc == 0) break;
        if (Take(connector, crtc, push)) return true;
      }
    }
    return false;
  }

  bool Take(std::size_t connector, std::size_t crtc, bool push) {
    const bool possible = ((connectors_[connector].crtcs & usable_ & ~tried_) >> crtc & 1) != 0;
    if (!possible || (driven_[crtc] && !push)) return false;
    tried_ |= 1U << crtc;
    if (driven_[crtc] && !Find(*driven_[crtc])) return false;
    driven_[crtc] = connector;
    return true;
  }

  const std::vector<KmsConnector>& connectors_;
  std::uint32_t usable_;
  std::array<std::optional<std::size_t>, 32> driven_;
  std::uint32_t tried_ = 0;
};

std::vector<KmsConnector> PluggedIn(KmsDevice& card) {
  std::vector<KmsConnector> found;
  const bool stirred = card.Stirred();
  for (const std::uint32_t id : card.Connectors()) {
    if (!stirred && card.PlugOf(id) == Plug::kEmpty) continue;
    auto connector = card.Probe(id);
    if (connector && connector->plugged) found.push_back(std::move(*connector));
  }
  return found;
}

}  // namespace

std::vector<std::uint32_t> PlanesOf(KmsDevice& card, std::size_t crtcs) {
  std::vector<std::uint32_t> planes(crtcs, 0);
  for (const KmsPlane& plane : card.PrimaryPlanes()) {
    for (std::size_t crtc = 0; crtc < crtcs; ++crtc) {
      if (planes[crtc] != 0 || (plane.crtcs >> crtc & 1) == 0) continue;
      planes[crtc] = plane.id;
      break;
    }
  }
  return planes;
}

Result<std::vector<KmsOutput>> FindOutputs(KmsDevice& card, const std::optional<drmModeModeInfo>& mode) {
  const auto connectors = PluggedIn(card);
  if (connectors.empty()) return Fail(std::errc::no_such_device, "find a screen on the graphics card");
  const auto crtcs = card.Crtcs();
  const auto planes = PlanesOf(card, crtcs.size());
  std::uint32_t usable = 0;
  for (std::size_t crtc = 0; crtc < crtcs.size(); ++crtc)
    if (planes[crtc] != 0) usable |= 1U << crtc;
  Wiring wiring(connectors, usable);
  for (std::size_t i = 0; i < connectors.size(); ++i) wiring.Wire(i);
  std::vector<KmsOutput> outputs;
  for (std::size_t i = 0; i < connectors.size(); ++i)
    if (const auto crtc = wiring.CrtcOf(i))
      outputs.push_back(
          {connectors[i].id, connectors[i].name, crtcs[*crtc], planes[*crtc], ModeFor(connectors[i], mode)});
  if (outputs.empty()) return Fail(std::errc::not_supported, "find a plane for the screen");
  return outputs;
}

ChosenMode ModeFor(const KmsConnector& connector, const std::optional<drmModeModeInfo>& mode) {
  return mode ? ChosenMode{*mode, true} : ChooseMode(connector.modes);
}

std::string Describe(const KmsOutput& output) {
  const auto& mode = output.chosen.mode;
  return fmt::format("{} {} x {} at {:.4g} Hz{}", output.name, mode.hdisplay, mode.vdisplay,
                     1 / Seconds(PeriodOf(mode)),
                     output.chosen.wished ? "" : ", which is safe: the screen itself asks for no mode");
}

}  // namespace kaori::scanout
