#include "appliance/programs/editor/own.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace kaori::editor {
namespace {

constexpr std::string_view kRemark =
    "# An expression made on the box with the needles. To give it to a show for good, add these lines to the "
    "end of\n"
    "# the show's expressions.toml.\n";
constexpr double kCentimetresPerMetre = 100;

// Four digits behind the point, none of them an idle zero. Zero has no sign.
std::string Number(double value) {
  std::string text = fmt::format("{:.4f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

// As written: outwards from the middle is positive u on both sides.
std::string Move(glm::vec3 pull_m, double side) {
  return fmt::format("[{}, {}, {}]", Number(side * static_cast<double>(pull_m.x) * kCentimetresPerMetre),
                     Number(static_cast<double>(pull_m.y) * kCentimetresPerMetre),
                     Number(static_cast<double>(pull_m.z) * kCentimetresPerMetre));
}

// As Move writes a pull that rounds to nothing.
const std::string kNoMove = "[0, 0, 0]";

// The lines of the three tables of a file, each point in one of them.
struct Tables {
  std::string both, left, right;
};

void AddLine(std::string& table, std::string_view name, const std::string& move) {
  if (move != kNoMove) table += fmt::format("{} = {}\n", name, move);
}

// A point in the middle: "both" moves it in the middle only.
void AddMiddle(Tables& tables, const std::string& name, glm::vec3 pull_m) {
  AddLine(Number(static_cast<double>(pull_m.x) * kCentimetresPerMetre) == "0" ? tables.both : tables.left,
          name, Move(pull_m, 1));
}

// A pair that moves alike is one line of "both"; otherwise each side has its own, without its ".l" or ".r".
void AddPair(Tables& tables, std::string_view name, const std::string& left, const std::string& right) {
  if (left == right) return AddLine(tables.both, name, left);
  AddLine(tables.left, name, left);
  AddLine(tables.right, name, right);
}

// Both sides are compared as they will be written: what differs by less than a micrometre is alike.
Tables TablesOf(const Work& work, const Points& points) {
  Tables tables;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string& name = points.names[i];
    if (points.partners[i] < 0) AddMiddle(tables, name, work.pulls_m[i]);
    if (points.partners[i] < 0 || points.OnTheRight(i)) continue;
    const auto right = static_cast<std::size_t>(points.partners[i]);
    AddPair(tables, std::string_view(name).substr(0, name.size() - 2), Move(work.pulls_m[i], 1),
            Move(work.pulls_m[right], -1));
  }
  return tables;
}

}  // namespace

// Tables that nothing moves in are left out, and so are lids that are open.
std::string WriteOwn(const Work& work, const Points& points) {
  std::string text = fmt::format("{}[[expression]]\nname = \"{}\"\n", kRemark, work.name);
  if (work.lids != std::array<float, 2>{})
    text += fmt::format("lids = [{}, {}]\n", Number(static_cast<double>(work.lids[0])),
                        Number(static_cast<double>(work.lids[1])));
  const Tables tables = TablesOf(work, points);
  if (!tables.both.empty()) text += "\n[expression.both]\n" + tables.both;
  if (!tables.left.empty()) text += "\n[expression.left]\n" + tables.left;
  if (!tables.right.empty()) text += "\n[expression.right]\n" + tables.right;
  return text;
}

// ASCII alone, in any locale: the name becomes a part of a file's name and a word of TOML.
bool IsName(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto allowed = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name.size() <= kLongestName && letter(name.front()) &&
         std::ranges::all_of(name, allowed);
}

}  // namespace kaori::editor
