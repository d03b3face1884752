// Faults of a cast, each made on purpose: it is found, and named with its face or table.
#include "render/face/check.h"

#include <limits>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/render/default_cast.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Fault {
  const char* name;
  void (*spoil)(face::Cast&);
  const char* line;
  friend void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }
};

// One of the two triangles of each of the first quads.
void TurnOver(face::Cast& cast, int count) {
  for (int i = 0; i < count; ++i) {
    auto& t = cast.topology.triangles[static_cast<std::size_t>(2 * i)];
    std::swap(t[1], t[2]);
  }
}

const Fault kFaults[] = {
    {"PositionIsNoNumber", [](face::Cast& c) { c.faces[1].positions[7].y = kNan; },
     "face \"round\": 1 positions are not numbers, the first is number 7"},
    {"OtherVertexCount", [](face::Cast& c) { c.faces[3].positions.pop_back(); }, "face \"long\": "},
    {"Centimetres", [](face::Cast& c) { c.faces[0].positions[0] *= 1000; }, "are these metres?"},
    {"TurnedTriangles", [](face::Cast& c) { TurnOver(c, 3); },
     "parameter space: 3 triangles are turned over"},
    {"ZeroAreaTriangle", [](face::Cast& c) { c.topology.triangles[5][2] = c.topology.triangles[5][1]; },
     "parameter space: 1 triangles have no area"},
    {"PlaceIsNoNumber", [](face::Cast& c) { c.topology.uv[3].x = kNan; },
     "parameter space: 1 coordinates are not numbers"},
    {"NoPlaces", [](face::Cast& c) { c.topology.uv.clear(); }, "parameter space: has 0 entries"},
    {"TriangleOutOfRange", [](face::Cast& c) { c.topology.triangles[0][0] = 99999; },
     "triangles: 1 indices out of range"},
    {"WireOutOfRange", [](face::Cast& c) { c.topology.wires[0][0] = 99999; },
     "wires: 1 indices out of range"},
    {"TwinsDisagree", [](face::Cast& c) { c.topology.twin[0] = 1; },
     "twins: a vertex is not the twin of its twin"},
    {"TwinOutOfRange", [](face::Cast& c) { c.topology.twin[0] = 99999; }, "twins: 1 indices out of range"},
    {"TooManyMove", [](face::Cast& c) { c.topology.moving_count = 99999; },
     "more vertices move than there are"},
    {"LidOutOfRange", [](face::Cast& c) { c.topology.lids[1].upper[3] = 99999; },
     "right lids, upper: 1 indices"},
    {"LidTooShort", [](face::Cast& c) { c.topology.lids[0].lower.pop_back(); }, "left lids, lower: has"},
    {"LidWithoutMargin", [](face::Cast& c) { c.topology.lids[0].margin_ring = 9; }, "do not make a lid"},
    {"RowsMalformed", [](face::Cast& c) { c.net.to_cage.row_start[1] = 99999; },
     "control points to cage: rows overlap"},
    {"RowsMissing", [](face::Cast& c) { c.net.to_cage.row_start.pop_back(); },
     "control points to cage, rows: has"},
    {"RowColumnOutOfRange", [](face::Cast& c) { c.net.surface.column[0] = 99999; },
     "control points on the surface: 1 ind"},
    {"RowWeightIsNoNumber", [](face::Cast& c) { c.net.to_cage.weight[9] = kNan; },
     "control points to cage: 1 values"},
    {"FineColumnOutOfRange", [](face::Cast& c) { c.topology.fine.from_cage.column[0] = 99999; },
     "fine mesh, positions: 1"},
    {"FineTriangleOutOfRange", [](face::Cast& c) { c.topology.fine.triangles[0][2] = 99999; },
     "fine mesh, triangles: 1"},
    {"PointOutside", [](face::Cast& c) { c.net.points[0].uv.x = 1.5F; },
     "control point \"UC\": lies outside"},
    {"ExpressionTooShort", [](face::Cast& c) { c.expressions[1].displacement.pop_back(); },
     "expression \"smile\": has"},
    {"ExpressionIsNoNumber", [](face::Cast& c) { c.expressions[2].displacement[0].z = kNan; },
     "expression \"surprised\": 1"},
    {"LidsBeyondShut", [](face::Cast& c) { c.expressions[1].lids[0] = 1.5F; },
     "its lids are not within 0 to 1"},
    {"PupilsAsLargeAsTheIris", [](face::Cast& c) { c.expressions[1].pupil = 2; },
     "its pupils are not within 0.5 to 1.5"},
    {"GainIsNoNumber", [](face::Cast& c) { c.faces[2].expression_gain = kNan; },
     "face \"turned\", its look: 1 values"},
    {"EyeWithoutPlace", [](face::Cast& c) { c.faces[0].eyes[1].centre.x = kNan; },
     "an eye has no position or size"},
    {"OcclusionTooShort", [](face::Cast& c) { c.faces[0].occlusion.pop_back(); },
     "face \"reference\", occlusion: has"},
    {"PropMissing", [](face::Cast& c) { c.faces[0].props.push_back(4); }, "prop 4 is missing"},
    {"TextureMissing",
     [](face::Cast& c) {
       c.textures.push_back({1, 1, {0, 0, 0, 0}});
       c.faces[2].surface.texture = 3;
     },
     "face \"turned\": texture 3 is missing"},
    {"TextureTooShort",
     [](face::Cast& c) {
       c.textures.push_back({2, 2, {0, 0, 0, 0}});
     },
     "texture 0, bytes: has 4"},
    {"PropOutOfRange",
     [](face::Cast& c) {
       c.props.push_back({.name = "bob", .part = {}, .colour = {}, .vertices = {}, .triangles = {{0, 1, 2}}});
     },
     "prop \"bob\": 3 indices out of range"},
    {"TextureBeyondAllSize",
     [](face::Cast& c) {
       c.textures.push_back({1 << 20, 1, {}});
     },
     "texture 0: is larger than 8192 pixels a side"},
    {"PropOfNoKnownPart",
     [](face::Cast& c) {
       c.props.push_back(
           {.name = "bob", .part = face::Part{5}, .colour = {}, .vertices = {}, .triangles = {}});
     },
     "prop \"bob\": is a part that does not exist"},
    {"PropColourIsNoNumber",
     [](face::Cast& c) {
       c.props.push_back(
           {.name = "bob", .part = {}, .colour = {0, kNan, 0}, .vertices = {}, .triangles = {}});
     },
     "prop \"bob\": its colour is not a number"},
    {"LockIsNoNumber",
     [](face::Cast& c) {
       c.props.push_back({.name = "bob", .part = {}, .colour = {}, .vertices = {{}}, .triangles = {}});
       c.props[0].vertices[0].across = kNan;
     },
     "prop \"bob\": a vertex holds what is not a number"},
    {"ExpressionOfNoKnownKind", [](face::Cast& c) { c.expressions[2].kind = face::ExpressionKind{3}; },
     "expression \"surprised\": is of a kind that does not exist"},
    {"FlushBeyondRed", [](face::Cast& c) { c.expressions[1].flush = 1.5F; },
     "its flush is not within 0 to 1"},
    {"FaceFlushedLessThanNot", [](face::Cast& c) { c.faces[1].surface.flush = -1; },
     "face \"round\": its flush is not within 0 to 1"},
    {"FaceFoldedTwice", [](face::Cast& c) { c.faces[1].surface.folds = 2; },
     "face \"round\": its folds are not within 0 to 1"},
    {"TeethAreNoNumber", [](face::Cast& c) { c.faces[1].mouth.lower_teeth = kNan; },
     "face \"round\", its look: 1 values"},
    {"IrisIsNoNumber", [](face::Cast& c) { c.faces[3].eye_look.iris.y = kNan; },
     "face \"long\", its look: 1 values"},
    {"EyeballIsNoNumber", [](face::Cast& c) { c.faces[3].eye_surface.pupil = kNan; },
     "face \"long\", its look: 1 values"},
    {"OutgrowthOfNoVertex", [](face::Cast& c) { c.topology.outgrowth = {9999999}; }, "outgrowth"},
    {"WithdrawnAnotherNumberOfVertices", [](face::Cast& c) { c.faces[1].withdrawn.resize(2); },
     "face \"round\", withdrawn"},
    {"OutgrowthOfNoKind", [](face::Cast& c) { c.faces[1].outgrowth_kind = 2; },
     "face \"round\": its kind of outgrowth is not within 0 to 1"},
    {"ArmsOfAnotherNumberOfVertices", [](face::Cast& c) { c.faces[1].hang_arms_m.resize(2); },
     "face \"round\", arms of what hangs"},
    {"AnArmThatIsNoLength",
     [](face::Cast& c) {
       c.topology.outgrowth = {7};
       c.faces[1].hang_arms_m = {{0, kNan}};
     },
     "face \"round\": an arm of what hangs is no length below 10 m"},
    {"NeckIsNowhere", [](face::Cast& c) { c.neck_pivot.z = kNan; },
     "cast: the neck or the mouth has no position"},
    {"NoFace", [](face::Cast& c) { c.faces.clear(); }, "cast: has no face"},
    {"NoExpression", [](face::Cast& c) { c.expressions.clear(); }, "cast: has no expression"},
};

class CastFault : public ::testing::TestWithParam<Fault> {};

TEST_P(CastFault, IsFoundAndNamed) {
  face::Cast cast = MakeSyntheticCast();
  GetParam().spoil(cast);
  EXPECT_THAT(face::FindFaults(cast), Contains(HasSubstr(GetParam().line)));
}

INSTANTIATE_TEST_SUITE_P(Each, CastFault, ::testing::ValuesIn(kFaults),
                         [](const auto& spoiled) { return std::string(spoiled.param.name); });

TEST(Check, FindsNothingWrongWithASoundCast) {
  EXPECT_THAT(face::FindFaults(MakeSyntheticCast()), IsEmpty());
}

TEST(Check, FindsNothingWrongWithTheDefaultCast) {
  EXPECT_THAT(face::FindFaults(DefaultCast()), IsEmpty());
}

TEST(Check, TellsEachFaultInALineOfItsOwn) {
  face::Cast cast = MakeSyntheticCast();
  cast.topology.wires[0][0] = 99999;
  cast.faces[1].positions[0].x = kNan;
  cast.faces[2].expression_gain = kNan;
  const auto faults = face::FindFaults(cast);
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0], "wires: 1 indices out of range, the first is number 0");
}

TEST(Check, FindsEveryFaultOfACastThatIsEmpty) {
  EXPECT_GE(face::FindFaults({}).size(), 2U);
}

}  // namespace
}  // namespace kaori::tests
