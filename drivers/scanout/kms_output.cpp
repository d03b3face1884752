#include "drivers/scanout/kms_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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
        if (Assign(connector, crtc, push)) return true;
      }
    }
    return false;
  }

  bool Assign(std::size_t connector, std::size_t crtc, bool push) {
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

bool IsSame(const drmModeModeInfo& one, const drmModeModeInfo& other) {
  return one.clock == other.clock && one.hdisplay == other.hdisplay && one.vdisplay == other.vdisplay &&
         one.htotal == other.htotal && one.vtotal == other.vtotal && one.flags == other.flags;
}

bool IsRefused(const KmsWishes& wishes, std::uint32_t connector, const drmModeModeInfo& mode) {
  return std::ranges::any_of(wishes.refused, [&](const KmsRefusal& refusal) {
    return refusal.connector == connector && IsSame(refusal.mode, mode);
  });
}

void ForgetRefusals(KmsWishes& wishes, const std::vector<KmsConnector>& plugged) {
  std::erase_if(wishes.refused, [&](const KmsRefusal& refusal) {
    return std::ranges::find(plugged, refusal.connector, &KmsConnector::id) == plugged.end();
  });
}

// The CRTCs that have a plane, as bits.
std::uint32_t UsableOf(const std::vector<std::uint32_t>& planes) {
  std::uint32_t usable = 0;
  for (std::size_t crtc = 0; crtc < planes.size(); ++crtc)
    if (planes[crtc] != 0) usable |= 1U << crtc;
  return usable;
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

Result<std::vector<KmsOutput>> FindOutputs(KmsDevice& card, KmsWishes& wishes) {
  auto connectors = PluggedIn(card);
  ForgetRefusals(wishes, connectors);
  if (connectors.empty()) return Fail(std::errc::no_such_device, "find a screen on the graphics card");
  std::erase_if(connectors, [&](const KmsConnector& connector) { return !ModeFor(connector, wishes); });
  const auto crtcs = card.Crtcs();
  const auto planes = PlanesOf(card, crtcs.size());
  Wiring wiring(connectors, UsableOf(planes));
  for (std::size_t i = 0; i < connectors.size(); ++i) wiring.Wire(i);
  std::vector<KmsOutput> outputs;
  for (std::size_t i = 0; i < connectors.size(); ++i)
    if (const auto crtc = wiring.CrtcOf(i))
      outputs.push_back({connectors[i].id, connectors[i].name, crtcs[*crtc], planes[*crtc],
                         *ModeFor(connectors[i], wishes)});
  if (outputs.empty()) return Fail(std::errc::not_supported, "show on any screen that is plugged in");
  return outputs;
}

std::optional<KmsOutput> ExtractStatusOutput(KmsDevice& card, const std::string& name, std::vector<KmsOutput>& outputs) {
  if (name.empty() || outputs.size() < 2) return std::nullopt;
  const auto connectors = card.Connectors();
  const auto number_of = [&](const KmsOutput& output) {
    return std::ranges::find(connectors, output.connector) - connectors.begin() + 1;
  };
  const auto found = std::ranges::find_if(outputs, [&](const KmsOutput& output) {
    return output.name == name || std::to_string(number_of(output)) == name;
  });
  if (found == outputs.end()) return std::nullopt;
  KmsOutput sign = std::move(*found);
  outputs.erase(found);
  return sign;
}

std::optional<ChosenMode> ModeFor(const KmsConnector& connector, const KmsWishes& wishes) {
  if (wishes.mode && !IsRefused(wishes, connector.id, *wishes.mode)) return ChosenMode{*wishes.mode, true};
  auto modes = connector.modes;
  std::erase_if(modes, [&](const auto& mode) { return IsRefused(wishes, connector.id, mode); });
  auto chosen = ChooseMode(modes);
  if (IsRefused(wishes, connector.id, chosen.mode)) return std::nullopt;
  chosen.instead = wishes.mode || modes.size() < connector.modes.size();
  return chosen;
}

std::string Describe(const KmsOutput& output) {
  const auto& mode = output.chosen.mode;
  const char* why = "";
  if (output.chosen.instead)
    why = ", in place of what the card refuses";
  else if (!output.chosen.wished)
    why = ", which is safe: the screen itself asks for no mode";
  return fmt::format("{} {} x {} at {:.4g} Hz{}", output.name, mode.hdisplay, mode.vdisplay,
                     1 / Seconds(PeriodOf(mode)), why);
}

}  // namespace kaori::scanout
