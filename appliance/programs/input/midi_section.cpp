#include "appliance/programs/input/midi_section.h"

#include <algorithm>
#include <chrono>

namespace kaori::input {
namespace {

using board::MidiHeard;

// The board's own number of what a device calls `of_device`; a list of a map may leave it out.
template <class List>
std::uint32_t OnBoard(const List& numbers, std::optional<std::size_t> of_device) {
  if (!of_device || *of_device >= numbers.size() || !numbers[*of_device]) return MidiHeard::kNothing;
  return *numbers[*of_device];
}

}  // namespace

// A device without a map plays the board's dials and buttons by their own numbers.
MidiHeard::Message MidiSection::MessageOf(const ports::MidiHeard& heard) const {
  static const SurfaceMap kUsual;
  const SurfaceMap* const map = MapFor(maps_, heard.vendor, heard.product);
  const SurfaceMap& of = map == nullptr ? kUsual : *map;
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(heard.at.time_since_epoch()).count();
  return {.at_ms = static_cast<std::uint32_t>(ms),
          .device = std::uint32_t{heard.vendor} << 16U | heard.product,
          .bytes = std::uint32_t{heard.status} | std::uint32_t{heard.number} << 8U |
                   std::uint32_t{heard.value} << 16U,
          .meant = OnBoard(of.dials, heard.dial) | OnBoard(of.buttons, heard.button) << 8U};
}

void MidiSection::Publish(const ports::MidiTap& tap) {
  if (tap.count() == seen_) return;
  const auto fresh = std::min<std::uint32_t>(tap.count() - seen_, ports::MidiTap::kKept);
  for (std::uint32_t n = tap.count() - fresh; n != tap.count(); ++n)
    heard_.newest[heard_.count++ % MidiHeard::kKept] = MessageOf(tap.message(n));
  seen_ = tap.count();
  writer_.Write(heard_, tap.message(seen_ - 1).at, board::SourceState::kLive);
}

}  // namespace kaori::input
