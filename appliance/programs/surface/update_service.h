// Updates the control surfaces of a box by itself, while somebody with the key works at it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "appliance/programs/surface/surface_update.h"

namespace kaori::surface_update {

// Each surface whose firmware is older than the box's update for it gets that update, one after the other,
// and one that was left in the middle of being tried is watched to its end. What failed on a chip is not
// tried on it again before the program is started anew. One thread.
class UpdateService {
 public:
  // Borrows the bus.
  UpdateService(ports::HidBus& bus, std::vector<UpdateFile> files) : bus_(bus), files_(std::move(files)) {}

  // The next piece of work, to be called every 50 ms or so. Looks at the surfaces once a second while the box
  // is in service; an update that has begun goes on to its end. How many dial boxes there are it counts
  // itself. Blocks as SurfaceUpdate::Step, and as the bus does where a device was just plugged in.
  void Step(Circumstances box, Time now);

  bool is_updating() const { return update_.has_value(); }

 private:
  using ChipId = std::array<std::uint8_t, 8>;
  struct Due {
    std::string port;
    ChipId chip;
    std::uint32_t version;  // That it has.
    const UpdateFile* file;
  };
  void Go(Time now);
  // The surfaces that want an update. Counts the dial boxes that play.
  std::vector<Due> Look(int& dial_boxes);
  // What a surface that says this of itself wants; nothing where it is up to date, or takes no update.
  std::optional<Due> DueAt(const ports::HidIdentity& identity, const wire::SurfaceStatus& status) const;
  const UpdateFile* NewestFor(std::uint32_t product) const;
  void Begin(const Due& due);

  ports::HidBus& bus_;
  const std::vector<UpdateFile> files_;
  std::optional<SurfaceUpdate> update_;
  ChipId chip_{};                                      // That is updated now,
  std::uint32_t version_ = 0;                          // and to which version.
  std::set<std::pair<ChipId, std::uint32_t>> failed_;  // Versions that a chip did not take.
  std::set<std::string> others_;                       // Ports with devices that are no surfaces of ours.
  std::string refusal_;                                // That was logged last.
  Time next_look_{};
};

}  // namespace kaori::surface_update
