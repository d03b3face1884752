// The slot of a surface: counts and pushes go to the board, lamps from the board to the device.
// Firmware of our own box: firmware/wire has the bytes of its reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/deck_pictures.h"
#include "appliance/programs/input/device_slot.h"
#include "appliance/programs/input/learnt_turns.h"
#include "appliance/programs/input/surface_map.h"
#include "appliance/programs/input/surface_section.h"
#include "appliance/programs/input/transfer_failures.h"
#include "drivers/decode/dial_box.h"

namespace kaori::input {

// Counts accumulate over plugs and restarts: turning an unplugged box moves nothing, and a box that is
// plugged in again goes on where its dials stood on the board.
class DialSlot final : public DeviceSlot {
 public:
  // Borrows all of them; they outlive the slot. `device` is its number in the section. The section Lamps of
  // the board is what the device shows.
  DialSlot(const board::Board& board, SurfaceSection& section, std::size_t device,
           const std::vector<SurfaceMap>& maps, const LearntTurns& turns);

  std::string_view name() const override { return device_ == 0 ? "dial box" : "further surface"; }
  Result<void> Plug(const ports::HidIdentity& identity, Time now) override;
  Result<void> Accept(std::span<const std::uint8_t> report, Time at) override;
  void Publish() override { section_.Publish(); }
  void Unplug(Time now) override;
  void Tick(Time now, ports::HidChannel* device) override;

  // The device that is plugged in, or was last.
  const ports::HidIdentity& identity() const { return identity_; }
  // When the device that is plugged in turned that dial of the board last; Time{}: it has not.
  Time turned_at(std::size_t dial) const { return turned_at_[dial]; }
  // What so many counts of the board are in counts of the device's own.
  double CountsOfItsOwn(std::uint32_t on_board) const;
  // How many of its own counts one turn has, from the next count on.
  void SetCountsPerTurn(int counts);

 private:
  // What the device's own dial turned, as counts of the board's.
  void Turn(std::size_t dial, std::int32_t counts, Time at);
  // Sends one output report where the lamps on the board differ from those that the box was last told, and
  // one each second.
  void ShowLamps(Time now, ports::HidChannel& device);
  // What the board says of each key of a Stream Deck.
  DeckPictures::Keys DeckKeys() const;

  const board::Board& board_;
  SurfaceSection& section_;
  std::size_t device_;
  const std::vector<SurfaceMap>& maps_;
  // Of a device that no file names.
  const SurfaceMap usual_;
  const SurfaceMap* map_ = &usual_;
  const LearntTurns& turns_;
  ports::HidIdentity identity_{};
  // What was learnt comes before what the map says; 0: neither says anything, and a count is one of the board's.
  int counts_per_turn_ = 0;
  std::array<Time, decode::kMaxDials> turned_at_{};  // By the board's dial.
  std::optional<decode::DialBoxDecoder> decoder_;
  // Counts of the decoder that the section has, and parts of a count that are left over, both by the device's
  // dial.
  std::array<std::int32_t, decode::kMaxDials> passed_on_{};
  std::array<std::int64_t, decode::kMaxDials> rests_{};
  // As the box was last told; empty after a plug, when all are dark.
  std::optional<std::uint32_t> lit_;
  // And when.
  Time told_{};
  // No lamp report is sent before this time.
  Time lamps_after_{};
  // Since the plug.
  TransferFailures lamp_failures_;
  // 0 keys: it is none.
  decode::StreamDeck deck_{};
  DeckPictures pictures_;
  // When the box was plugged in, from which kHeldStateTrust counts.
  Time plugged_{};
  // False while held buttons are known only from before the plug.
  bool held_confirmed_ = true;
};

}  // namespace kaori::input
