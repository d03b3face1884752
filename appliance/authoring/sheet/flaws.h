// What an inspection found, by face and expression, in the few words that a small picture has room for.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "appliance/authoring/inspect/inspect.h"

namespace kaori::authoring {

// Made once from an inspection, then asked for each cell. Keeps copies of what it needs.
class Flaws {
 public:
  // Nothing was inspected: every On() is empty.
  Flaws() : summary_("not inspected") {}
  // Copies what it needs of the inspection.
  explicit Flaws(const inspect::Inspection& inspection);

  // "3 folds", "lids 0.2 mm² with brow_up", "5 flaws, 3 folds with a"; empty: none. A pose belongs to the
  // expression that its name begins with; shut lids on the face at rest to kLidsShut.
  std::string On(const std::string& face, const std::string& expression) const;

  // For the sheet's head: "0 folds, 2 lid gaps, 0 teeth through lips".
  const std::string& summary() const { return summary_; }
  // Whether anything was found.
  bool any() const { return !found_.empty(); }

  // The label of the cell that shows shut lids; also the end of such poses' names.
  static constexpr const char* kLidsShut = "lids shut";

 private:
  // How many flaws a cell has, and the first of them in words.
  struct Found {
    int count = 0;
    std::string first;
  };
  // By face and expression.
  std::map<std::pair<std::string, std::string>, Found> found_;
  std::string summary_;
};

}  // namespace kaori::authoring
