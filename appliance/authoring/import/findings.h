// The faults of a set of files, all of them: each one line with file, item and reason.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::import {

class Findings {
 public:
  // "woman.glb: target "jawOpen": 3 offsets are no numbers".
  void Add(std::string_view file, std::string_view item, std::string_view reason);

  bool empty() const { return lines_.empty(); }
  const std::vector<std::string>& lines() const { return lines_; }
  std::size_t size() const { return lines_.size() + dropped_; }

  // All lines as one error. There must be one.
  tl::unexpected<Error> Refuse() const;

 private:
  static constexpr std::size_t kMost = 200;
  std::vector<std::string> lines_;
  std::size_t dropped_ = 0;
};

}  // namespace kaori::import
