#include "appliance/authoring/model/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kaori::model {

void Findings::Add(std::string_view file, std::string_view item, std::string_view reason) {
  // Later faults are counted only.
  if (lines_.size() >= kMost) {
    ++dropped_;
    return;
  }
  lines_.push_back(item.empty() ? fmt::format("{}: {}", file, reason)
                                : fmt::format("{}: {}: {}", file, item, reason));
}

// Whoever mends the first two hundred faults has mended the cause of the rest.
tl::unexpected<Error> Findings::Refuse() const {
  std::string text = fmt::format("{}", fmt::join(lines_, "\n"));
  if (dropped_ > 0) text += fmt::format("\n(and {} more)", dropped_);
  return FailInput(std::move(text));
}

}  // namespace kaori::model
