#include "appliance/authoring/sculpt/expressions.h"

#include <cstddef>

namespace kaori::sculpt {
namespace {

// Adds what a side's moves say of a point; on the right, u runs the other way, which `side` turns (0: no
// part of it).
void AddMove(const Moves& moves, const std::string& point, double side, glm::vec3& displacement) {
  const auto move = moves.find(point);
  if (move == moves.end()) return;
  displacement += glm::vec3(move->second * glm::dvec3(side, 1, 1) * kMetresPerCentimetre);
}

// In the order of MakeControlNet's points: left before right.
void AddMoves(const std::vector<AuthoredPoint>& points, const AuthoredExpression& authored,
              std::vector<glm::vec3>& displacement) {
  std::size_t at = 0;
  for (const AuthoredPoint& point : points) {
    // The middle does not move sideways,
    const double left = point.paired ? 1 : 0;
    AddMove(authored.both, point.name, left, displacement[at]);
    AddMove(authored.left, point.name, 1, displacement[at]);  // unless one side pulls it.
    if (!point.paired) AddMove(authored.right, point.name, -1, displacement[at]);
    ++at;
    if (!point.paired) continue;
    AddMove(authored.both, point.name, -1, displacement[at]);
    AddMove(authored.right, point.name, -1, displacement[at]);
    ++at;
  }
}

const face::Expression& Find(const std::vector<face::Expression>& made, const std::string& name) {
  std::size_t i = 0;
  while (made[i].name != name) ++i;  // The reader has seen to it that it is there.
  return made[i];
}

std::size_t CountPoints(const std::vector<AuthoredPoint>& points) {
  std::size_t count = 0;
  for (const AuthoredPoint& point : points) count += point.paired ? 2 : 1;
  return count;
}

}  // namespace

// Lids are not summed up from what an expression builds on: they are said by each.
std::vector<face::Expression> MakeExpressions(const ExpressionFile& file) {
  std::vector<face::Expression> made;
  const std::size_t count = CountPoints(file.points);
  for (const AuthoredExpression& authored : file.expressions) {
    face::Expression expression;
    expression.name = authored.name;
    expression.kind = authored.kind;
    expression.displacement.assign(count, glm::vec3(0));
    for (const auto& [name, share] : authored.from) {
      const face::Expression& base = Find(made, name);
      for (std::size_t i = 0; i < count; ++i) {
        expression.displacement[i] += static_cast<float>(share) * base.displacement[i];
      }
    }
    AddMoves(file.points, authored, expression.displacement);
    expression.lids = {static_cast<float>(authored.lids[0]), static_cast<float>(authored.lids[1])};
    expression.pupil = static_cast<float>(authored.pupil);
    expression.flush = static_cast<float>(authored.flush);
    made.push_back(std::move(expression));
  }
  return made;
}

}  // namespace kaori::sculpt
