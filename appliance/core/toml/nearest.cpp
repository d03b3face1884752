#include "appliance/core/toml/nearest.h"

#include <cstddef>

namespace kaori::toml {
namespace {

// ASCII only: names in our files have no other letters.
char Small(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// The distance of Damerau and Levenshtein, in its restricted form: no pair of letters is touched twice. Row
// i, column j hold the distance of the first i letters of `a` from the first j of `b`.
std::size_t Distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) table[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) table[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = Small(a[i - 1]) == Small(b[j - 1]);
      std::size_t& least = table[i][j];
      least = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1, table[i - 1][j - 1] + (same ? 0 : 1)});
      const bool swapped =
          i > 1 && j > 1 && Small(a[i - 1]) == Small(b[j - 2]) && Small(a[i - 2]) == Small(b[j - 1]);
      if (swapped) least = std::min(least, table[i - 2][j - 2] + 1);
    }
  return table[a.size()][b.size()];
}

constexpr std::size_t kLongestName =
    64;  // Longer ones are not compared: the table would grow with the square.

}  // namespace

// As many letters may differ as a third of the length, one more where the name has more than one letter, and
// two at most; `least` is one above that, since only a smaller distance counts. Of equally near names the
// first is given. A distance of a name's whole length would mean that nothing of it was written.
std::string_view Nearest(std::string_view written, const std::vector<std::string_view>& names) {
  std::string_view nearest;
  std::size_t least = std::min<std::size_t>(2, written.size() / 3 + (written.size() > 1 ? 1 : 0)) + 1;
  if (written.size() > kLongestName) return nearest;
  for (const std::string_view name : names) {
    if (name.size() > kLongestName) continue;
    const std::size_t distance = Distance(written, name);
    if (distance >= least || distance >= name.size()) continue;
    least = distance;
    nearest = name;
  }
  return nearest;
}

std::string DidYouMean(std::string_view written, const std::vector<std::string_view>& names) {
  const std::string_view nearest = Nearest(written, names);
  return nearest.empty() ? std::string() : "; did you mean \"" + std::string(nearest) + "\"?";
}

}  // namespace kaori::toml
