#include "appliance/authoring/sculpt/expression_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "appliance/authoring/sculpt/texture_map.h"
#include "appliance/core/toml/nearest.h"
#include "appliance/core/toml/section.h"

namespace kaori::sculpt {
namespace {

// Nearer to u = 0 than this lies in the middle.
constexpr double kExpressionFileOnMiddle_cm = 1e-9;

// How far an expression may move a point along one axis, the same as for the box's own editor; most move by
// half a centimetre. One that moves none by kLeastMove_cm is not seen: it was written in metres.
constexpr double kMostMove_cm = 5;
constexpr double kLeastMove_cm = 0.02;

// None where the value is not a list of two numbers.
std::optional<glm::dvec2> AsUv(const toml::Value& value) {
  if (value.kind != toml::Value::Kind::kList || value.list.size() != 2) return std::nullopt;
  for (const toml::Value& item : value.list) {
    if (item.kind != toml::Value::Kind::kNumber) return std::nullopt;
  }
  return glm::dvec2(value.list[0].number, value.list[1].number);
}

// The middle counts as left.
bool IsOnLeftHalf(glm::dvec2 uv_cm) {
  return uv_cm.x >= 0 && uv_cm.x <= kUvMax_cm.x && uv_cm.y >= kUvMin_cm.y && uv_cm.y <= kUvMax_cm.y;
}

// Reads the file's three parts in turn; later ones ask what earlier ones named. Faults go to the sections
// that they concern. Borrows topology and reference.
class Reader {
 public:
  Reader(const HalfTopology& half, const HalfShape& reference) : half_(half), reference_(reference) {}

  ExpressionFile Read(toml::Section file) {
    file.AllowOnly({"point", "border", "expression"});
    ReadPoints(file.Part("point"));
    ReadBorder(file);
    for (const toml::Section& expression : file.Parts("expression")) ReadExpression(expression);
    if (file_.expressions.empty() || file_.expressions.front().name != "neutral") {
      file.Fault("expression", "the first one must be \"neutral\"");
    }
    return std::move(file_);
  }

 private:
  // A point is u and v, or a vertex whose uv is asked of the reference.
  void ReadPoints(toml::Section section) {
    for (const auto& [name, value] : section.table().table) {
      const std::optional<Key> vertex = AsVertex(value.text);
      // A text that is no vertex's name, and a list, have an empty text: AsVertex answers none for both.
      const std::optional<glm::dvec2> uv_cm = vertex ? UvOf(*vertex) : AsUv(value);
      if (!uv_cm || !IsOnLeftHalf(*uv_cm)) {
        section.Fault(
            name, "must be a position [u, v] on the left half of the face, in centimetres, or name a vertex");
        continue;
      }
      file_.points.push_back({name, *uv_cm, uv_cm->x > kExpressionFileOnMiddle_cm, vertex});
    }
    if (file_.points.size() < 3) section.Fault("", "there must be three points at least");
  }

  // `vertex` comes from AsVertex, which knows names of vertices that are there and no others: At finds it.
  std::optional<glm::dvec2> UvOf(const Key& vertex) const {
    return reference_.uv_cm[half_.At(vertex.region, vertex.a, vertex.b)];
  }

  // Stops at the first position that is none, since a list has one fault.
  void ReadBorder(toml::Section& file) {
    const toml::Value* border = file.Find("border");
    if (border == nullptr || border->kind != toml::Value::Kind::kList)
      return file.Fault("border", "must be a list of positions [u, v]");
    for (const toml::Value& item : border->list) {
      const std::optional<glm::dvec2> uv_cm = AsUv(item);
      if (!uv_cm || !IsOnLeftHalf(*uv_cm))
        return file.Fault("border", "each must be a position [u, v] on the left half, in centimetres");
      file_.border_cm.push_back(*uv_cm);
    }
  }

  // An expression with a fault is kept all the same: later ones may build on it.
  void ReadExpression(toml::Section section) {
    section.AllowOnly({"name", "kind", "lids", "pupil", "flush", "from", "both", "left", "right"});
    AuthoredExpression expression{.name = section.Text("name")};
    // Names are how buttons, motions and other expressions call it.
    if (FindExpression(expression.name) != nullptr)
      section.Fault("name",
                    fmt::format("another expression has it already: \"{}\" is given twice", expression.name));
    expression.kind = ReadKind(section);
    if (section.Has("lids")) expression.lids = ReadLids(section);
    if (section.Has("pupil")) expression.pupil = ReadPupil(section);
    if (section.Has("flush")) expression.flush = ReadFlush(section);
    if (section.Has("from")) expression.from = ReadFrom(section.Part("from"));
    if (section.Has("both")) expression.both = ReadMoves(section.Part("both"));
    if (section.Has("left")) expression.left = ReadMoves(section.Part("left"));
    if (section.Has("right")) expression.right = ReadMoves(section.Part("right"));
    CheckThatItMoves(section, expression);
    file_.expressions.push_back(std::move(expression));
  }

  // An expression without moves is fine (neutral, or one made of others); one whose moves nobody sees is a
  // slip of the unit.
  static void CheckThatItMoves(toml::Section& section, const AuthoredExpression& expression) {
    double most_cm = 0;
    for (const Moves* moves : {&expression.both, &expression.left, &expression.right})
      for (const auto& [name, move] : *moves)
        most_cm = std::max({most_cm, std::abs(move.x), std::abs(move.y), std::abs(move.z)});
    if (most_cm > 0 && most_cm < kLeastMove_cm)
      section.Fault(
          "", fmt::format("moves no point by more than {} cm, which nobody sees: lengths are centimetres",
                          most_cm));
  }

  // What has no kind is an expression; so is, after its fault, what has an unknown one.
  static face::ExpressionKind ReadKind(toml::Section& section) {
    const std::string kind = section.TextOr("kind", "expression");
    if (kind == "mouth") return face::ExpressionKind::kMouth;
    if (kind == "channel") return face::ExpressionKind::kChannel;
    if (kind != "expression")
      section.Fault("kind", "must be \"expression\", \"mouth\" or \"channel\"" +
                                toml::DidYouMean(kind, {"expression", "mouth", "channel"}));
    return face::ExpressionKind::kExpression;
  }

  static std::array<double, 2> ReadLids(toml::Section& section) {
    const std::vector<double> lids = section.Numbers("lids");
    const bool good =
        lids.size() == 2 && std::all_of(lids.begin(), lids.end(), [](double x) { return x >= 0 && x <= 1; });
    if (!good) {
      section.Fault("lids", "must be two numbers from 0 (open) to 1 (shut): left, right");
      return {};
    }
    return {lids[0], lids[1]};
  }

  static double ReadPupil(toml::Section& section) {
    const double pupil = section.Number("pupil");
    if (pupil >= 0.5 && pupil <= 1.5) return pupil;
    section.Fault("pupil", "must be a factor from 0.5 (small) to 1.5 (large); 1 is as the face has it");
    return 1;
  }

  static double ReadFlush(toml::Section& section) {
    const double flush = section.Number("flush");
    if (flush >= 0 && flush <= 1) return flush;
    section.Fault("flush", "must be a number from 0 to 1 (as red as can be)");
    return 0;
  }

  // Only expressions that stand before this one, so that sums need no order of their own.
  std::map<std::string, double> ReadFrom(toml::Section section) {
    std::map<std::string, double> from;
    for (const auto& [name, value] : section.table().table) {
      if (FindExpression(name) == nullptr)
        section.Fault(name, "is no expression written before this one" +
                                toml::DidYouMeanOneOf(name, file_.expressions));
      from[name] = section.Number(name);
    }
    return from;
  }

  // By point name; a name that is no point is a fault, with one that may be meant.
  Moves ReadMoves(toml::Section section) {
    Moves moves;
    for (const auto& [name, value] : section.table().table) {
      if (!HasPoint(name))
        section.Fault(name, "is no control point" + toml::DidYouMeanOneOf(name, file_.points));
      const glm::dvec3 move = section.Point(name);
      const double most_cm = std::max({std::abs(move.x), std::abs(move.y), std::abs(move.z)});
      if (most_cm > kMostMove_cm)
        section.Fault(name, fmt::format("moves by {}, and {} is the most: lengths are centimetres", most_cm,
                                        kMostMove_cm));
      moves[name] = move;
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
  const Result<toml::Value> value = toml::ReadToml(path);
  if (!value) return tl::unexpected(value.error());
  toml::Faults faults(path.string());
  ExpressionFile file = Reader(half, reference).Read(toml::Section(*value, "", faults));
  const Result<void> verdict = faults.Verdict();
  if (!verdict) return tl::unexpected(verdict.error());
  return file;
}

}  // namespace kaori::sculpt
