// Which regions of paint are the mouth, and which the marker: blue clothes and passing hands are neither.
#pragma once

#include <optional>
#include <vector>

#include "appliance/programs/lips/region.h"
#include "drivers/base/clock.h"

namespace kaori::lips {

struct Found {
  Region mouth;                      // The hull of its parts.
  std::vector<std::uint32_t> parts;  // Names of its regions: lips that are open may lie apart.
  std::optional<Region> marker;      // The dot on nose or forehead.
};

// Remembers where a good mouth was: there it is looked for first, and with time ever further around.
class MouthSearch {
 public:
  // `marker`: whether a dot of the same paint is worn on nose or forehead.
  explicit MouthSearch(bool marker = false) : wants_marker_(marker) {}

  // Where it was tells nothing: pictures of another size.
  void Forget() { last_.reset(); }

  // Null where nothing in the picture can be a mouth. The result is valid until the next call.
  const Found* Find(Regions& regions, const Grid& grid, Time at);

  // What was found is a mouth indeed. Noise that looks like one is not remembered.
  void Remember(const Grid& grid, Time at);

 private:
  struct Last {
    float x_px;
    float y_px;
    float width_px;
    Time at;
  };
  float Likelihood(const Region& region, const Grid& grid, Time at) const;
  void TakeParts(std::span<const Region> all, const Region& largest, const Grid& grid);
  void TakeMarker(std::span<const Region> all);

  bool wants_marker_;
  std::optional<Last> last_;
  Found found_;
};

}  // namespace kaori::lips
