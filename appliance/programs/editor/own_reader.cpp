#include "appliance/programs/editor/own.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

namespace kaori::editor {
namespace {

constexpr float kMetresPerCentimetre = 0.01F;
constexpr double kFarthest_cm = 5;

// Reads one expression; keeps the first complaint, after which nothing that it read is used.
class Reader {
 public:
  Reader(std::string file, const Points& points, const face::Cast& cast)
      : file_(std::move(file)), points_(points), cast_(cast) {
    work_.pulls_m.resize(points.size());
  }

  Result<Work> Read(const toml::table& file) {
    const toml::array* expressions = file["expression"].as_array();
    if (expressions == nullptr || expressions->size() != 1 || !expressions->front().is_table())
      return FailInput(file_ + ": must hold one [[expression]]");
    for (const auto& [key, value] : file)
      if (key.str() != "expression") Complain(value, fmt::format("\"{}\" does not exist", key.str()));
    for (const auto& [key, value] : *expressions->front().as_table()) ReadItem(key.str(), value);
    if (complaint_.empty() && !IsName(work_.name)) complaint_ = file_ + ": it has no name";
    if (!complaint_.empty()) return FailInput(complaint_);
    return std::move(work_);
  }

 private:
  void Complain(const toml::node& at, const std::string& what) {
    if (complaint_.empty()) complaint_ = fmt::format("{}:{}: {}", file_, at.source().begin.line, what);
  }

  void ReadItem(std::string_view key, const toml::node& value) {
    if (key == "name") return ReadName(value);
    if (key == "lids") return ReadLids(value);
    if (key == "from") return ReadFrom(value);
    if (key == "both" || key == "left" || key == "right") return ReadMoves(key, value);
    if (key == "kind" && value.value<std::string>() == "expression") return;
    Complain(value, fmt::format("\"{}\" is not for an expression of the box's own", key));
  }

  void ReadName(const toml::node& value) {
    work_.name = value.value<std::string>().value_or("");
    if (!IsName(work_.name)) Complain(value, "the name must be letters, digits and _, 24 at most");
  }

  void ReadLids(const toml::node& value) {
    const auto lids = Numbers(value, 2);
    if (!lids || !std::ranges::all_of(*lids, [](double lid) { return lid >= 0 && lid <= 1; }))
      return Complain(value, "lids must be two numbers from 0 to 1");
    work_.lids = {static_cast<float>((*lids)[0]), static_cast<float>((*lids)[1])};
  }

  void ReadFrom(const toml::node& value) {
    if (!value.is_table()) return Complain(value, "from must be a table");
    for (const auto& [name, share] : *value.as_table()) {
      const auto base = std::ranges::find(cast_.expressions, name.str(), &face::Expression::name);
      const auto weight = share.value<double>();
      if (base == cast_.expressions.end() || !weight || !(std::abs(*weight) <= 4)) {
        Complain(share, fmt::format("from {}: no expression of the show, or no number", name.str()));
        continue;
      }
      for (std::size_t i = 0; i < points_.size(); ++i)
        work_.pulls_m[i] += static_cast<float>(*weight) * base->displacement[i];
    }
  }

  void ReadMoves(std::string_view table, const toml::node& value) {
    if (!value.is_table()) return Complain(value, fmt::format("{} must be a table", table));
    for (const auto& [name, item] : *value.as_table()) {
      const auto move = Numbers(item, 3);
      const auto far = [](double part) { return !(std::abs(part) <= kFarthest_cm); };
      if (!move || std::ranges::any_of(*move, far))
        Complain(item, fmt::format("{}: must be three numbers of 5 cm at most", name.str()));
      else if (!AddMove(table, std::string(name.str()), glm::vec3((*move)[0], (*move)[1], (*move)[2])))
        Complain(item, fmt::format("{}: is no control point of this show", name.str()));
    }
  }

  // "both" leaves a point of the middle in the middle; "right" sees u the other way.
  bool AddMove(std::string_view table, const std::string& name, glm::vec3 move_cm) {
    const glm::vec3 move_m = move_cm * kMetresPerCentimetre;
    const glm::vec3 mirrored_m = move_m * glm::vec3(-1, 1, 1);
    const bool left = table != "right", right = table != "left";
    if (left && right && Add(name, move_m * glm::vec3(0, 1, 1))) return true;
    if (left != right && Add(name, left ? move_m : mirrored_m)) return true;
    return (!left || Add(name + ".l", move_m)) && (!right || Add(name + ".r", mirrored_m));
  }

  bool Add(const std::string& point, glm::vec3 by_m) {
    const auto found = std::ranges::find(points_.names, point);
    if (found == points_.names.end()) return false;
    work_.pulls_m[static_cast<std::size_t>(found - points_.names.begin())] += by_m;
    return true;
  }

  static std::optional<std::vector<double>> Numbers(const toml::node& value, std::size_t count) {
    const toml::array* array = value.as_array();
    if (array == nullptr || array->size() != count) return std::nullopt;
    std::vector<double> numbers;
    for (const toml::node& item : *array) {
      const auto number = item.value<double>();
      if (!number) return std::nullopt;
      numbers.push_back(*number);
    }
    return numbers;
  }

  std::string file_;
  const Points& points_;
  const face::Cast& cast_;
  Work work_;
  std::string complaint_;
};

}  // namespace

Result<Work> ReadOwn(std::string_view text, const std::string& file, const Points& points,
                     const face::Cast& cast) {
  const toml::parse_result parsed = toml::parse(text, file);
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    return FailInput(fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
  }
  return Reader(file, points, cast).Read(parsed.table());
}

}  // namespace kaori::editor
