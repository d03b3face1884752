// Any bytes as what desk and lips say to each other, or as a settings file: they are read or refused, and
// what was read can be said again.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

#include "appliance/programs/lips/lip_settings.h"
#include "appliance/programs/lips/protocol/protocol.h"
#include "tests/fuzz/check.h"

namespace kaori::fuzz {
namespace {

void TryCommand(std::string_view text) {
  const auto command = lips::ParseCommand(text);
  if (!command) return;
  Promise(std::isfinite(command->a) && std::isfinite(command->b), "a command's numbers are numbers");
  const auto again = lips::ParseCommand(lips::CommandText(*command));
  Promise(again && again->kind == command->kind && again->name == command->name && again->a == command->a,
          "a command can be said again");
}

void TryReport(std::span<const std::uint8_t> packet) {
  const auto report = lips::ReadReport(packet);
  if (!report) return;
  Promise(report->progress >= 0 && report->progress <= 1, "progress lies between none and all");
  Promise(std::ranges::all_of(report->values, [](float value) { return std::isfinite(value); }),
          "settings are numbers");
  Promise(lips::ReadReport(lips::Packet(*report)) == report, "a report can be said again");
}

void TryPicture(std::span<const std::uint8_t> packet) {
  const auto note = lips::ReadPictureNote(packet);
  if (!note) return;
  Promise(note->slot < lips::kPictureSlots, "a slot is one that is there");
  Promise(note->width_px * note->height_px * 4 <= lips::kPictureSlotBytes, "a picture fits into its slot");
}

void TrySettings(std::string_view text) {
  const auto settings = lips::ParseLipSettings(text, "fuzz");
  if (!settings) return;
  const auto again = lips::ParseLipSettings(lips::LipSettingsText(*settings), "again");
  Promise(again && *again == *settings, "settings can be written and read again");
}

}  // namespace
}  // namespace kaori::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  kaori::fuzz::TryCommand(text);
  kaori::fuzz::TryReport(bytes);
  kaori::fuzz::TryPicture(bytes);
  kaori::fuzz::TrySettings(text);
  return 0;
}
