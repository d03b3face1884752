// Which connectors of a graphics card show a picture, each through which CRTC and plane, in which mode.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/scanout/kms_device.h"
#include "drivers/scanout/kms_mode.h"
#include "drivers/scanout/kms_wishes.h"

namespace kaori::scanout {

struct KmsOutput {
  std::uint32_t connector = 0;
  std::string name;
  std::uint32_t crtc = 0;
  std::uint32_t plane = 0;
  ChosenMode chosen;
};

// Every screen that is plugged in and can be driven beside the others, in the card's order, each in the first
// mode that the card has not refused. Where the card cannot drive them all, as many as it can. What was
// refused is forgotten with a screen that was pulled. Probes no connector that the kernel knows to be empty,
// but where it says that something changed. Errors: no_such_device (no screen is plugged in), not_supported
// (the card can show on none of them).
Result<std::vector<KmsOutput>> FindOutputs(KmsDevice& card, KmsWishes& wishes);

// Takes the sign out of the outputs: none where nobody wishes for one, where it is not among them, or where
// it is the only screen, which is the show's.
std::optional<KmsOutput> ExtractStatusOutput(KmsDevice& card, const std::string& name, std::vector<KmsOutput>& outputs);

// For each CRTC, in the card's order, a primary plane of its own; 0 where there is none.
std::vector<std::uint32_t> PlanesOf(KmsDevice& card, std::size_t crtcs);

// The mode in which the screen is to be shown; none where the card has refused all of them.
std::optional<ChosenMode> ModeFor(const KmsConnector& connector, const KmsWishes& wishes);

// For people: "HDMI-A-1 1920 x 1080 at 60 Hz".
std::string Describe(const KmsOutput& output);

}  // namespace kaori::scanout
