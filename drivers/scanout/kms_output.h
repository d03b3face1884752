// Finds the screens of a graphics card, and gives each a CRTC, a plane and a mode.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/scanout/kms_device.h"
#include "drivers/scanout/kms_mode.h"
#include "drivers/scanout/kms_preferences.h"

namespace kaori::scanout {

// A connector with a screen, and what it is driven by: one CRTC, one primary plane, one mode.
struct KmsOutput {
  // KMS's numbers of connector, CRTC and plane; the name is the connector's.
  std::uint32_t connector = 0;
  std::string name;
  std::uint32_t crtc = 0;
  std::uint32_t plane = 0;
  ChosenMode chosen;
  // As KmsConnector says; until it is set up again.
  bool link_is_bad = false;
};

// Every screen that is plugged in, in the card's order, each in the first mode that the card has not refused.
// Where the card cannot drive them all together, as many as it can. Refusals are forgotten with a screen that
// was pulled. Probes every connector after a hotplug report, and else only those that the kernel does not
// know to be empty: each takes tens of milliseconds. Errors:
//   no_such_device  no screen is plugged in
//   not_supported   the card can show on none of them
Result<std::vector<KmsOutput>> FindOutputs(KmsDevice& card, KmsPreferences& preferences);

// Removes a display that is no part of the picture from the outputs. `name` is the connector's, or its number
// on the card from 1. None where `name` is empty or not among the outputs, or where it is the only screen,
// which is the show's: people who pull a cable keep the face.
std::optional<KmsOutput> ExtractSideOutput(KmsDevice& card, const std::string& name,
                                           std::vector<KmsOutput>& outputs);

// For each CRTC, in the card's order, a primary plane of its own; 0 where there is none. The first plane
// that fits is used, as most cards have one fixed plane for each CRTC.
std::vector<std::uint32_t> PlanesOf(KmsDevice& card, std::size_t crtcs);

// The mode that people prefer, else ChooseMode's; without those that the card refused. None where it
// refused all of them. Its origin tells whether it is what was wanted. Pure.
std::optional<ChosenMode> ModeFor(const KmsConnector& connector, const KmsPreferences& preferences);

// The output as the port tells it, with the rate of its mode. Pure.
ports::Output PortOutput(const KmsOutput& output, ports::OutputState state);

}  // namespace kaori::scanout
