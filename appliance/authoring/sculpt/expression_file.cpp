#include "appliance/authoring/sculpt/expression_file.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "appliance/authoring/sculpt/section.h"
#include "appliance/authoring/sculpt/texture_map.h"

namespace kaori::sculpt {
namespace {

constexpr double kExpressionFileOnMiddle_cm = 1e-9;

std::optional<glm::dvec2> AsPlace(const Value& value) {
  if (value.kind != Value::Kind::kList || value.list.size() != 2) return std::nullopt;
  for (const Value& item : value.list) {
    if (item.kind != Value::Kind::kNumber) return std::nullopt;
  }
  return glm::dvec2(value.list[0].number, value.list[1].number);
}

bool IsOnLeftHalf(glm::dvec2 place) {
  return place.x >= 0 && place.x <= kPlaceMax_cm.x && place.y >= kPlaceMin_cm.y && place.y <= kPlaceMax_cm.y;
}

class Reader {
 public:
  Reader(const HalfTopology& half, const HalfShape& reference) : half_(half), reference_(reference) {}

  ExpressionFile Read(Section file) {
    file.AllowOnly({"point", "border", "expression"});
    ReadPoints(file.Part("point"));
    ReadBorder(file);
    for (const Section& expression : file.Parts("expression")) ReadExpression(expression);
    if (file_.expressions.empty() || file_.expressions.front().name != "neutral") {
      file.Fault("expression", "the first one must be \"neutral\"");
    }
    return std::move(file_);
  }

 private:
  void ReadPoints(Section section) {
    for (const auto& [name, value] : section.table().table) {
      const std::optional<Key> vertex = AsVertex(value.word);
      const std::optional<glm::dvec2> place = vertex ? PlaceOf(*vertex) : AsPlace(value);
      if (!place || !IsOnLeftHalf(*place)) {
        section.Fault(name, "must be a place [u, v] on the left half of the face, or name a vertex");
        continue;
      }
      file_.points.push_back({name, *place, place->x > kExpressionFileOnMiddle_cm, vertex});
    }
    if (file_.points.size() < 3) section.Fault("", "there must be three points at least");
  }

  std::optional<glm::dvec2> PlaceOf(const Key& vertex) const {
    return reference_.place[half_.At(vertex.region, vertex.a, vertex.b)];
  }

  void ReadBorder(Section& file) {
    const Value* border = file.Find("border");
    if (border == nullptr || border->kind != Value::Kind::kList)
      return file.Fault("border", "must be a list of places");
    for (const Value& item : border->list) {
      const std::optional<glm::dvec2> place = AsPlace(item);
      if (!place || !IsOnLeftHalf(*place))
        return file.Fault("border", "each must be a place [u, v] on the left half");
      file_.border_cm.push_back(*place);
    }
  }

  void ReadExpression(Section section) {
    section.AllowOnly({"name", "kind", "lids", "from", "both", "left", "right"});
    AuthoredExpression expression{.name = section.Word("name")};
    if (FindExpression(expression.name) != nullptr)
      section.Fault("name", "another expression has it already");
    expression.kind = ReadKind(section);
    if (section.Has("lids")) expression.lids = ReadLids(section);
    if (section.Has("from")) expression.from = ReadFrom(section.Part("from"));
    if (section.Has("both")) expression.both = ReadMoves(section.Part("both"));
    if (section.Has("left")) expression.left = ReadMoves(section.Part("left"));
    if (section.Has("right")) expression.right = ReadMoves(section.Part("right"));
    file_.expressions.push_back(std::move(expression));
  }

  static face::ExpressionKind ReadKind(Section& section) {
    const std::string kind = section.WordOr("kind", "expression");
    if (kind == "mouth") return face::ExpressionKind::kMouth;
    if (kind == "channel") return face::ExpressionKind::kChannel;
    if (kind != "expression") section.Fault("kind", "must be \"expression\", \"mouth\" or \"channel\"");
    return face::ExpressionKind::kExpression;
  }

  static std::array<double, 2> ReadLids(Section& section) {
    const std::vector<double> lids = section.Numbers("lids");
    const bool good =
        lids.size() == 2 && std::all_of(lids.begin(), lids.end(), [](double x) { return x >= 0 && x <= 1; });
    if (!good) {
      section.Fault("lids", "must be two numbers from 0 (open) to 1 (shut): left, right");
      return {};
    }
    return {lids[0], lids[1]};
  }

  std::map<std::string, double> ReadFrom(Section section) {
    std::map<std::string, double> from;
    for (const auto& [name, value] : section.table().table) {
      if (FindExpression(name) == nullptr) section.Fault(name, "is no expression written before this one");
      from[name] = section.Number(name);
    }
    return from;
  }

  Moves ReadMoves(Section section) {
    Moves moves;
    for (const auto& [name, value] : section.table().table) {
      if (!HasPoint(name)) section.Fault(name, "is no control point");
      moves[name] = section.Point(name);
    }
    return moves;
  }

  bool HasPoint(const std::string& name) const {
    return std::any_of(file_.points.begin(), file_.points.end(),
                       [&name](const AuthoredPoint& point) { return point.name == name; });
  }

  const AuthoredExpression* FindExpression(const std::string& name) const {
    const auto found = std::find_if(file_.expressions.begin(), file_.expressions.end(),
                                    [&name](const AuthoredExpression& e) { return e.name == name; });
    return found == file_.expressions.end() ? nullptr : &*found;
  }

  const HalfTopology& half_;
  const HalfShape& reference_;
  ExpressionFile file_;
};

}  // namespace

Result<ExpressionFile> ReadExpressionFile(const std::filesystem::path& path, const HalfTopology& half,
                                          const HalfShape& reference) {
  const Result<Value> value = ReadToml(path);
  if (!value) return tl::unexpected(value.error());
  Faults faults(path.string());
  ExpressionFile file = Reader(half, reference).Read(Section(*value, "", faults));
  const Result<void> verdict = faults.Verdict();
  if (!verdict) return tl::unexpected(verdict.error());
  return file;
}

}  // namespace kaori::sculpt
