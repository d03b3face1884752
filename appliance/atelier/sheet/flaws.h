// What an inspection found, by face and expression, in the few words that a small picture has room for.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "appliance/atelier/inspect/inspect.h"

namespace kaori::atelier {

class Flaws {
 public:
  Flaws() = default;
  explicit Flaws(const inspect::Inspection& inspection);

  // "3 folds, lids 0.2 mm²"; empty: none. Lids that are shut at rest are named kLidsShut.
  std::string On(const std::string& face, const std::string& expression) const;

  // "0 folds, 2 lid gaps, 0 teeth through lips".
  const std::string& summary() const { return summary_; }
  bool any() const { return !words_.empty(); }

  static constexpr const char* kLidsShut = "lids shut";

 private:
  std::map<std::pair<std::string, std::string>, std::string> words_;
  std::string summary_;
};

}  // namespace kaori::atelier
