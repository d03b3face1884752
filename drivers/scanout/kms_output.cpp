#include "drivers/scanout/kms_output.h"

#include <algorithm>
#include <array>

namespace kaori::scanout {
namespace {

// Assigns CRTCs to connectors: a maximum matching by Kuhn's algorithm, in which a connector
// may move another one on to a CRTC that is free. A card of three CRTCs may reach a
// connector by one of them alone: first come, first served would leave it dark. Connectors
// and CRTCs are indices into the card's order.
class CrtcMatching {
 public:
  CrtcMatching(const std::vector<KmsConnector>& connectors, std::uint32_t usable)
      : connectors_(connectors), usable_(usable) {}

  void Add(std::size_t connector) {
    tried_ = 0;
    Assign(connector);
  }

  // The index of the connector's CRTC; none where it got none.
  std::optional<std::size_t> CrtcOf(std::size_t connector) const {
    const auto found = std::ranges::find(driven_, std::optional(connector));
    if (found == driven_.end()) return std::nullopt;
    return std::size_t(found - driven_.begin());
  }

 private:
  // Free CRTCs come first, so that the other connectors keep theirs.
  bool Assign(std::size_t connector) {
    for (const bool move : {false, true}) {
      for (std::size_t crtc = 0; crtc < driven_.size(); ++crtc) {
        if ((connectors_[connector].crtcs & usable_ & ~tried_) >> crtc == 0) break;
        if (AssignTo(connector, crtc, move)) return true;
      }
    }
    return false;
  }

  // Gives the CRTC to the connector where it is free, or where its connector finds another one.
  bool AssignTo(std::size_t connector, std::size_t crtc, bool move) {
    const bool possible = ((connectors_[connector].crtcs & usable_ & ~tried_) >> crtc & 1) != 0;
    if (!possible || (driven_[crtc] && !move)) return false;
    tried_ |= 1U << crtc;
    if (driven_[crtc] && !Assign(*driven_[crtc])) return false;
    driven_[crtc] = connector;
    return true;
  }

  const std::vector<KmsConnector>& connectors_;
  std::uint32_t usable_;
  // The connector that each CRTC drives; a card has 32 CRTCs at most, the bits of a mask.
  std::array<std::optional<std::size_t>, 32> driven_;
  // CRTCs that were looked at for the connector that is being added: each is
  // tried once, so that the search ends.
  std::uint32_t tried_ = 0;
};

// The connectors that have a screen, with its modes. Probing blocks; connectors that the kernel knows to
// be empty are left out, unless a uevent says that something changed.
std::vector<KmsConnector> PluggedIn(KmsDevice& card) {
  std::vector<KmsConnector> found;
  const bool hotplug = card.DrainHotplug();
  for (const std::uint32_t id : card.Connectors()) {
    if (!hotplug && card.ConnectionOf(id) == Connection::kDisconnected) continue;
    auto connector = card.Probe(id);
    if (connector && connector->plugged) found.push_back(std::move(*connector));
  }
  return found;
}

// Names and types of modes differ between probes of the same screen: timings count.
bool IsSame(const drmModeModeInfo& one, const drmModeModeInfo& other) {
  return one.clock == other.clock && one.hdisplay == other.hdisplay && one.vdisplay == other.vdisplay &&
         one.htotal == other.htotal && one.vtotal == other.vtotal && one.flags == other.flags;
}

// Whether the card refused this mode on this connector since the screen was plugged in.
bool IsRefused(const KmsPreferences& preferences, std::uint32_t connector, const drmModeModeInfo& mode) {
  return std::ranges::any_of(preferences.refused, [&](const KmsRefusal& refusal) {
    return refusal.connector == connector && IsSame(refusal.mode, mode);
  });
}

// Another screen may be plugged in next: what was refused was of the one that is gone.
void ForgetRefusals(KmsPreferences& preferences, const std::vector<KmsConnector>& plugged) {
  std::erase_if(preferences.refused, [&](const KmsRefusal& refusal) {
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

// By index of the CRTC, 0 where it has none. A plane that fits several goes to the first of them without one.
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

Result<std::vector<KmsOutput>> FindOutputs(KmsDevice& card, KmsPreferences& preferences) {
  auto connectors = PluggedIn(card);
  ForgetRefusals(preferences, connectors);
  if (connectors.empty()) return Fail(std::errc::no_such_device, "find a screen on the graphics card");
  std::erase_if(connectors, [&](const KmsConnector& connector) { return !ModeFor(connector, preferences); });
  const auto crtcs = card.Crtcs();
  const auto planes = PlanesOf(card, crtcs.size());
  CrtcMatching matching(connectors, UsableOf(planes));
  for (std::size_t i = 0; i < connectors.size(); ++i) matching.Add(i);
  std::vector<KmsOutput> outputs;
  for (std::size_t i = 0; i < connectors.size(); ++i)
    if (const auto crtc = matching.CrtcOf(i))
      outputs.push_back({connectors[i].id, connectors[i].name, crtcs[*crtc], planes[*crtc],
                         *ModeFor(connectors[i], preferences), connectors[i].link_is_bad});
  if (outputs.empty()) return Fail(std::errc::not_supported, "show on any screen that is plugged in");
  return outputs;
}

std::optional<KmsOutput> ExtractSideOutput(KmsDevice& card, const std::string& name,
                                           std::vector<KmsOutput>& outputs) {
  if (name.empty() || outputs.size() < 2) return std::nullopt;
  const auto connectors = card.Connectors();
  // People count connectors from 1.
  const auto number_of = [&](const KmsOutput& output) {
    return std::ranges::find(connectors, output.connector) - connectors.begin() + 1;
  };
  const auto found = std::ranges::find_if(outputs, [&](const KmsOutput& output) {
    return output.name == name || std::to_string(number_of(output)) == name;
  });
  if (found == outputs.end()) return std::nullopt;
  KmsOutput side = std::move(*found);
  outputs.erase(found);
  return side;
}

// Nothing: all that could be tried was refused by the card. Whatever is shown in place of a mode that was
// wished for, by a setting or by the screen, is marked as a substitute.
std::optional<ChosenMode> ModeFor(const KmsConnector& connector, const KmsPreferences& preferences) {
  if (preferences.mode && !IsRefused(preferences, connector.id, *preferences.mode))
    return ChosenMode{*preferences.mode, ports::ModeOrigin::kWanted};
  auto modes = connector.modes;
  std::erase_if(modes, [&](const auto& mode) { return IsRefused(preferences, connector.id, mode); });
  auto chosen = ChooseMode(modes);
  if (IsRefused(preferences, connector.id, chosen.mode)) return std::nullopt;
  // A refusal of another mode than the one that is chosen of all changes nothing.
  if (preferences.mode || IsRefused(preferences, connector.id, ChooseMode(connector.modes).mode))
    chosen.origin = ports::ModeOrigin::kSubstitute;
  return chosen;
}

ports::Output PortOutput(const KmsOutput& output, ports::OutputState state) {
  const auto& mode = output.chosen.mode;
  return {.connector = output.name,
          .width_px = mode.hdisplay,
          .height_px = mode.vdisplay,
          .rate_hz = 1 / Seconds(PeriodOf(mode)),
          .origin = output.chosen.origin,
          .state = state};
}

}  // namespace kaori::scanout
