#include "appliance/atelier/sheet/flaws.h"

#include <fmt/format.h>

namespace kaori::atelier {
namespace {

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

}  // namespace

Flaws::Flaws(const inspect::Inspection& inspection) {
  summary_ = fmt::format("{} folds, {} lid gaps, {} teeth through lips", inspection.folds,
                         inspection.lid_gaps, inspection.teeth_through_lips);
  for (const inspect::Finding& finding : inspection.findings) {
    std::string& words = words_[{finding.face, finding.expression}];
    words += (words.empty() ? "" : ", ") + Words(finding);
  }
}

std::string Flaws::On(const std::string& face, const std::string& expression) const {
  const auto found = words_.find({face, expression});
  return found == words_.end() ? "" : found->second;
}

}  // namespace kaori::atelier
