#include "appliance/programs/editor/own.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "appliance/core/toml/value.h"

namespace kaori::editor {
namespace {

constexpr float kMetresPerCentimetre = 0.01F;
// The bound of Session: a file asks for no more than an author can.
constexpr double kFarthest_cm = 5;

// Reads one expression; keeps the first complaint, after which nothing that it read is used. "both", "left"
// and "right" may name the same point; their moves add up, and to what "from" brings.
class Reader {
 public:
  Reader(std::string file, const Points& points, const face::Cast& cast)
      : file_(std::move(file)), points_(points), cast_(cast) {
    work_.pulls_m.resize(points.size());
  }

  // The file has the form of a show's expressions.toml with one expression, so that it can be copied there as
  // it is.
  Result<Work> Read(const toml::Value& file) {
    const toml::Value* expressions = toml::Find(file, "expression");
    if (expressions == nullptr || expressions->list.size() != 1 ||
        expressions->list.front().kind != toml::Value::Kind::kTable)
      return FailInput(file_ + ": must hold one [[expression]]");
    for (const auto& [key, value] : file.table)
      if (key != "expression") Complain(value, fmt::format("\"{}\" does not exist", key));
    for (const auto& [key, value] : expressions->list.front().table) ReadItem(key, value);
    if (complaint_.empty() && !IsName(work_.name)) complaint_ = file_ + ": it has no name";
    if (!complaint_.empty()) return FailInput(complaint_);
    return std::move(work_);
  }

 private:
  void Complain(const toml::Value& at, const std::string& what) {
    if (complaint_.empty()) complaint_ = fmt::format("{}:{}: {}", file_, at.line, what);
  }

  // Keys of a show's expressions that the box's own do not have are named as such.
  void ReadItem(std::string_view key, const toml::Value& value) {
    if (key == "name") return ReadName(value);
    if (key == "lids") return ReadLids(value);
    if (key == "from") return ReadFrom(value);
    if (key == "both" || key == "left" || key == "right") return ReadMoves(key, value);
    if (key == "kind" && value.text == "expression") return;
    Complain(value, fmt::format("\"{}\" is not for an expression of the box's own", key));
  }

  void ReadName(const toml::Value& value) {
    work_.name = value.text;
    if (!IsName(work_.name)) Complain(value, "the name must be letters, digits and _, 24 at most");
  }

  // Left and right, from 0 (open) to 1 (shut).
  void ReadLids(const toml::Value& value) {
    const auto lids = Numbers(value, 2);
    if (!lids || !std::ranges::all_of(*lids, [](double lid) { return lid >= 0 && lid <= 1; }))
      return Complain(value, "lids must be two numbers from 0 to 1");
    work_.lids = {static_cast<float>((*lids)[0]), static_cast<float>((*lids)[1])};
  }

  // A weighted sum of expressions of the show, as in its own recipes. Weights of more than 4 are a typing
  // error.
  void ReadFrom(const toml::Value& value) {
    if (value.kind != toml::Value::Kind::kTable) return Complain(value, "from must be a table");
    for (const auto& [name, share] : value.table) {
      const auto base = std::ranges::find(cast_.expressions, name, &face::Expression::name);
      const bool is_weight = share.kind == toml::Value::Kind::kNumber && std::abs(share.number) <= 4;
      if (base == cast_.expressions.end() || !is_weight) {
        Complain(share, fmt::format("from {}: no expression of the show, or no number", name));
        continue;
      }
      for (std::size_t i = 0; i < points_.size(); ++i)
        work_.pulls_m[i] += static_cast<float>(share.number) * base->displacement[i];
    }
  }

  // A place that no control point of this show has is a fault: the expression may be of another show.
  void ReadMoves(std::string_view table, const toml::Value& value) {
    if (value.kind != toml::Value::Kind::kTable)
      return Complain(value, fmt::format("{} must be a table", table));
    for (const auto& [name, item] : value.table) {
      const auto move = Numbers(item, 3);
      const auto far = [](double part) { return std::abs(part) > kFarthest_cm; };
      if (!move || std::ranges::any_of(*move, far))
        Complain(item, fmt::format("{}: must be three numbers of 5 cm at most", name));
      else if (!AddMove(table, name, glm::vec3((*move)[0], (*move)[1], (*move)[2])))
        Complain(item, fmt::format("{}: is no control point of this show", name));
    }
  }

  // "both" leaves a point of the middle in the middle; "right" sees u the other way. A name without ".l" or
  // ".r" stands for the pair, or for a point of the middle. False: there is no such point.
  bool AddMove(std::string_view table, const std::string& name, glm::vec3 move_cm) {
    const glm::vec3 move_m = move_cm * kMetresPerCentimetre;
    const glm::vec3 mirrored_m = move_m * glm::vec3(-1, 1, 1);
    const bool left = table != "right", right = table != "left";
    if (left && right && Add(name, move_m * glm::vec3(0, 1, 1))) return true;
    if (left != right && Add(name, left ? move_m : mirrored_m)) return true;
    return (!left || Add(name + ".l", move_m)) && (!right || Add(name + ".r", mirrored_m));
  }

  // False where the cast has no point of this name.
  bool Add(const std::string& point, glm::vec3 by_m) {
    const auto found = std::ranges::find(points_.names, point);
    if (found == points_.names.end()) return false;
    work_.pulls_m[static_cast<std::size_t>(found - points_.names.begin())] += by_m;
    return true;
  }

  // Nothing unless it is a list of exactly so many numbers.
  static std::optional<std::vector<double>> Numbers(const toml::Value& value, std::size_t count) {
    if (value.kind != toml::Value::Kind::kList || value.list.size() != count) return std::nullopt;
    std::vector<double> numbers;
    for (const toml::Value& item : value.list) {
      if (item.kind != toml::Value::Kind::kNumber) return std::nullopt;
      numbers.push_back(item.number);
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

// The parser's fault is told first: what follows needs a table.
Result<Work> ReadOwn(std::string_view text, const std::string& file, const Points& points,
                     const face::Cast& cast) {
  const auto value = toml::Parse(text, file);
  if (!value) return tl::unexpected(value.error());
  return Reader(file, points, cast).Read(*value);
}

}  // namespace kaori::editor
