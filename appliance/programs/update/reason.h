// Why a system gives way, for whoever stands before the box: one line in each of its languages.
#pragma once

#include <string>

namespace kaori::update {

struct Reason {
  std::string english{};
  std::string japanese{};
  // There is none.
  bool empty() const { return english.empty(); }
  friend bool operator==(const Reason&, const Reason&) = default;
};

}  // namespace kaori::update
