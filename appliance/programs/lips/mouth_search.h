// Which regions of paint are the mouth, and which one is the marker; blue clothes and passing hands are
// neither. Each region gets a likelihood by its area, its form and its distance from the last mouth; the best
// one is the larger part of the mouth, and others that lie as its second lip would are added to it.
#pragma once

#include <optional>
#include <vector>

#include "appliance/programs/lips/region.h"
#include "drivers/base/clock.h"

namespace kaori::lips {

// What may be the mouth of a picture. All in samples of the grid.
struct Candidate {
  Region mouth;                      // The bounding box of its parts.
  std::vector<std::uint32_t> parts;  // The names of its regions; the lips of an open mouth may be apart.
  std::optional<Region> marker;      // The dot on nose or forehead, where one is worn and seen.
};

// Remembers where the last usable mouth was. The search prefers that position, and with time ever farther
// ones. Used by one thread; allocates nothing once it has seen a few pictures.
class MouthSearch {
 public:
  // `marker` says whether the operator wears a dot of the same paint on nose or forehead. Only then is a dot
  // looked for.
  explicit MouthSearch(bool marker = false) : wants_marker_(marker) {}

  // Forgets the last position, which means nothing in pictures of another size.
  void Forget() { last_.reset(); }

  // Finds the most likely mouth, or null where no region can be one. The result is valid until the next call.
  const Candidate* Find(Regions& regions, const Grid& grid, Time at);

  // Confirms that the candidate was a mouth, so that its position is remembered. Noise must not be confirmed.
  void Remember(const Grid& grid, Time at);

 private:
  // The last mouth that was confirmed: its middle and its width, in pixels of the picture.
  struct Last {
    float x_px;
    float y_px;
    float width_px;
    Time at;
  };
  // How likely a region is the larger part of the mouth: 0 .. 1, to be compared with those of other regions.
  float Likelihood(const Region& region, const Grid& grid, Time at) const;
  // Fills candidate_ with the regions that make one mouth with the largest of them.
  void FindParts(std::span<const Region> all, const Region& largest, const Grid& grid);
  // Adds the marker to candidate_, where one is worn and seen.
  void FindMarker(std::span<const Region> all);

  bool wants_marker_;
  std::optional<Last> last_;
  Candidate candidate_;
};

}  // namespace kaori::lips
