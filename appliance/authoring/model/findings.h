// The faults of a set of files, all of them: each one line with file, item and reason.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::model {

// Collects faults while reading goes on, so that an artist sees every one of them at once instead of one a
// run. Passed by reference through the readers and checks; it owns its text.
class Findings {
 public:
  // `item` may be empty, where the fault is the whole file's. The line reads "file: item: reason",
  // or "file: reason":
  //   woman.glb: target "jawOpen": 3 offsets are no numbers
  void Add(std::string_view file, std::string_view item, std::string_view reason);

  // The lines, in the order in which they were found; size() counts also those that were dropped
  // beyond the 200th.
  bool empty() const { return lines_.empty(); }
  const std::vector<std::string>& lines() const { return lines_; }
  std::size_t size() const { return lines_.size() + dropped_; }

  // All lines as one error of kind input, one a line, with "(and N more)" at the end where some were dropped.
  // There must be one.
  tl::unexpected<Error> Refuse() const;

 private:
  // A broken file can have a fault for each vertex; nobody reads more than this.
  static constexpr std::size_t kMost = 200;
  std::vector<std::string> lines_;
  std::size_t dropped_ = 0;
};

}  // namespace kaori::model
