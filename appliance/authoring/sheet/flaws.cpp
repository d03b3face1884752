#include "appliance/authoring/sheet/flaws.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace kaori::authoring {
namespace {

// As few as a cell of the sheet has room for.
std::string Words(const inspect::Finding& finding) {
  switch (finding.flaw) {
    case inspect::Flaw::kFold:
      return finding.count == 1 ? "1 fold" : fmt::format("{} folds", finding.count);
    case inspect::Flaw::kLidGap:
      return fmt::format("lids {:.1f} mm\u00b2", finding.measure);
    case inspect::Flaw::kTeethThroughLips:
      return fmt::format("teeth {:.1f} mm", finding.measure);
  }
  return "?";
}

// A pose's name taken apart: "laugh with a, lids shut" is "laugh", and " with a, lids shut" besides.
struct PoseName {
  std::string expression;
  std::string besides;
};

// Poses are named by inspect::PosesToSee.
PoseName Split(const std::string& pose) {
  const std::string shut = std::string(", ") + Flaws::kLidsShut;
  if (pose == "neutral" + shut) return {Flaws::kLidsShut, ""};
  const std::size_t end = std::min({pose.find(" with "), pose.find(shut), pose.size()});
  return {pose.substr(0, end), pose.substr(end)};
}

}  // namespace

Flaws::Flaws(const inspect::Inspection& inspection) {
  summary_ = fmt::format("{} folds, {} lid gaps, {} teeth through lips", inspection.folds,
                         inspection.lid_gaps, inspection.teeth_through_lips);
  for (const inspect::Finding& finding : inspection.findings) {
    const PoseName pose = Split(finding.pose);
    Found& found = found_[{finding.face, pose.expression}];
    // The first flaw is told in words, later ones are counted.
    if (++found.count == 1) found.first = Words(finding) + pose.besides;
  }
}

std::string Flaws::On(const std::string& face, const std::string& expression) const {
  const auto at = found_.find({face, expression});
  if (at == found_.end()) return "";
  const Found& found = at->second;
  return found.count == 1 ? found.first : fmt::format("{} flaws, {}", found.count, found.first);
}

}  // namespace kaori::authoring
