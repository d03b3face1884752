// What somebody may have meant who wrote a name that does not exist.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace kaori::toml {

// Of `names` the one that differs from `written` by the fewest letters left out, put in, changed, or swapped
// with their neighbour; capitals do not matter. Empty where none is close: more than a third of the letters,
// or of two, differ. Borrows the names. Pure; the effort grows with the product of the lengths, of 64 letters
// at most.
std::string_view Nearest(std::string_view written, const std::vector<std::string_view>& names);

// "; did you mean \"smile\"?", to be put behind a reason; empty where nothing is close.
std::string DidYouMean(std::string_view written, const std::vector<std::string_view>& names);

// The same for things that have a name.
template <class Items>
std::string DidYouMeanOneOf(std::string_view written, const Items& items) {
  std::vector<std::string_view> names;
  for (const auto& item : items) names.emplace_back(item.name);
  return DidYouMean(written, names);
}

}  // namespace kaori::toml
