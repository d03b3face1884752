// A whole head goes out into a file and comes back.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "appliance/authoring/import/bridge.h"
#include "appliance/authoring/import/head_shape.h"
#include "appliance/core/show/check.h"
#include "appliance/core/show/pack.h"
#include "render/face/frame.h"
#include "tests/appliance/authoring/import_head.h"

namespace kaori::import {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Imported once for all tests.
const Imported& TheImport() {
  static const Imported made = [] {
    const TemporaryFolder folder;
    Model head = ExportedHead();
    WriteGlb(folder.path() / "her.glb", head);
    head.targets.clear();
    for (glm::vec3& p : head.positions) p.x *= 1.1F;
    WriteGlb(folder.path() / "wide.glb", head);
    auto result = Import({folder.path() / "her.glb", folder.path() / "wide.glb"}, &DefaultShow(), {});
    if (!result) ADD_FAILURE() << result.error().message();
    return result ? std::move(*result) : Imported{};
  }();
  return made;
}

const face::Expression* Find(const face::Cast& cast, std::string_view name) {
  const auto found = std::ranges::find(cast.expressions, name, &face::Expression::name);
  return found == cast.expressions.end() ? nullptr : &*found;
}

float Longest(const Offsets& offsets) {
  float most = 0;
  for (const glm::vec3& offset : offsets) most = std::max(most, glm::length(offset));
  return most;
}

TEST(ImportedHead, IsASoundShow) {
  EXPECT_THAT(show::CheckShow(TheImport().heads), IsEmpty());
  ASSERT_TRUE(TheImport().on_show);
  EXPECT_THAT(show::CheckShow(*TheImport().on_show), IsEmpty());
}

TEST(ImportedHead, BecomesAFaceForEachFile) {
  const face::Cast& cast = TheImport().heads.cast;
  ASSERT_EQ(cast.faces.size(), 2U);
  EXPECT_EQ(cast.faces[0].name, "her");
  EXPECT_EQ(cast.faces[1].name, "wide");
}

TEST(ImportedHead, HasItsEyesFoundAndPutToTheMiddle) {
  const auto& theirs = TheImport().heads.cast.faces[0].eyes;
  const auto& ours = DefaultShow().cast.faces[0].eyes;
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_NEAR(theirs[side].radius_m, kHeadScale * ours[side].radius_m, 2e-4);
    EXPECT_NEAR(theirs[side].centre.x, kHeadScale * ours[side].centre.x, 5e-4);
    EXPECT_NEAR(theirs[side].centre.y, 0, 1e-3);
  }
  EXPECT_EQ(TheImport().heads.cast.topology.vertex_count, DefaultShow().cast.topology.vertex_count);
}

TEST(ImportedHead, WearsTheArtistsShapeExactlyOnItsOwnFace) {
  const face::Cast& cast = TheImport().heads.cast;
  const face::Expression* wibble = Find(cast, "wibble");
  ASSERT_NE(wibble, nullptr);
  const Offsets worn = OffsetsOfCast(cast, *wibble);
  const Offsets drawn = OffsetsOfCast(DefaultShow().cast, *Find(DefaultShow().cast, "funny"));
  EXPECT_NEAR(Longest(worn), kHeadScale * Longest(drawn), 1e-5);
  // Vertices were put into another order: every place must have moved as the artist drew it.
  double drawn_sum = 0;
  double worn_sum = 0;
  for (const glm::vec3& d : drawn) drawn_sum += glm::length(d);
  for (const glm::vec3& d : worn) worn_sum += glm::length(d);
  EXPECT_NEAR(worn_sum, kHeadScale * drawn_sum, 1e-4 * drawn_sum);
}

TEST(ImportedHead, ShutsItsLidsByTheArtistsBlink) {
  const face::Cast& cast = TheImport().heads.cast;
  ASSERT_GE(cast.blink[0], 0);
  EXPECT_EQ(cast.expressions[static_cast<std::size_t>(cast.blink[0])].name, "blink_left");
  const HeadShape shape = ShapeOfCast(cast);  // Asks for lids shut.
  EXPECT_GT(Longest(shape.blink[0]), 0.010F);
  float other_side = 0;
  for (std::size_t v = 0; v < shape.blink[0].size(); ++v)
    if (shape.positions[v].x < -0.01F) other_side = std::max(other_side, glm::length(shape.blink[0][v]));
  EXPECT_LT(other_side, 1e-4F);
}

TEST(ImportedHead, WearsTheShowsExpressionsWhereItHasNoneOfItsOwn) {
  // Carried to a copy of the same head, larger by a fifth, an expression is the same, larger by a fifth.
  const Offsets carried = OffsetsOfCast(TheImport().heads.cast, *Find(TheImport().heads.cast, "smile"));
  const Offsets own = OffsetsOfCast(DefaultShow().cast, *Find(DefaultShow().cast, "smile"));
  EXPECT_NEAR(Longest(carried), kHeadScale * Longest(own), 0.15F * Longest(own));
  const auto role = std::ranges::find(TheImport().report.roles, "smile", &ReportedRole::name);
  EXPECT_THAT(role->made_of, HasSubstr("carried over"));
}

TEST(ImportedHead, KeepsButtonsThatStillFit) {
  EXPECT_EQ(TheImport().heads.buttons[0].kind, show::CallKind::kNothing);  // There is no fifth face.
  EXPECT_EQ(TheImport().heads.buttons[1].kind, show::CallKind::kFace);
  EXPECT_EQ(TheImport().heads.second_buttons[0].kind, show::CallKind::kNothing);
  EXPECT_EQ(TheImport().heads.second_buttons[1].mode, show::CallMode::kToggle);
  EXPECT_EQ(TheImport().heads.keys[0].call.kind, show::CallKind::kNothing);
  EXPECT_EQ(TheImport().heads.face_fades.size(), TheImport().heads.cast.faces.size());
}

TEST(ImportedHead, IsDrawnFinerThanItIsKept) {
  const face::Topology& topology = TheImport().heads.cast.topology;
  EXPECT_GE(topology.fine.triangles.size(), 3 * topology.triangles.size());
  EXPECT_EQ(topology.fine.texture.size(), topology.fine.from_cage.rows());
}

TEST(ImportedHead, WearsWhatTheShowsFaceWearsFittedToItsSize) {
  const face::Cast& cast = TheImport().heads.cast;
  ASSERT_EQ(cast.props.size(), 2U);  // The cap of the show's first face, on either head.
  EXPECT_EQ(cast.faces[0].props, std::vector<int>{0});
  EXPECT_EQ(cast.faces[1].props, std::vector<int>{1});
  const auto widest = [](const face::Prop& prop) {
    float x_m = 0;
    for (const face::PropVertex& vertex : prop.vertices) x_m = std::max(x_m, vertex.position.x);
    return x_m;
  };
  const float own = widest(DefaultShow().cast.props[0]);
  EXPECT_NEAR(widest(cast.props[0]), kHeadScale * own, 0.06F * own);
  EXPECT_NEAR(widest(cast.props[1]), 1.1F * kHeadScale * own, 0.06F * own);
  for (const face::PropVertex& vertex : cast.props[1].vertices)
    EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-3);
}

TEST(ImportedHead, SaysTheSameToPrograms) {
  const auto json = nlohmann::json::parse(JsonText(TheImport().report));
  EXPECT_EQ(json["shapes"].size(), TheImport().report.shapes.size());
  EXPECT_EQ(json["shapes_not_mapped"], nlohmann::json::array({"wibble"}));
  EXPECT_TRUE(json["shapes"].back()["means"].is_null());
  EXPECT_GT(json["shapes"][0]["rms_mm"].get<double>(), 0);
}

TEST(ImportedHead, SurvivesItsPack) {
  const TemporaryFolder folder;
  const auto saved = show::SavePack(TheImport().heads, folder.path() / "heads.kaori");
  ASSERT_TRUE(saved) << saved.error().message();
  const auto loaded = show::LoadPack(folder.path() / "heads.kaori");
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->cast.blink, TheImport().heads.cast.blink);
  ASSERT_NE(Find(loaded->cast, "wibble"), nullptr);
  EXPECT_FALSE(Find(loaded->cast, "wibble")->residual.empty());
  EXPECT_EQ(Find(loaded->cast, "wibble")->residual, Find(TheImport().heads.cast, "wibble")->residual);
}

TEST(ImportedHead, LendsItsShapesToTheShow) {
  const face::Cast& cast = TheImport().on_show->cast;
  const face::Expression* wibble = Find(cast, "wibble");
  ASSERT_NE(wibble, nullptr);
  const Offsets lent = OffsetsOfCast(cast, *wibble);
  const Offsets own = OffsetsOfCast(cast, *Find(cast, "funny"));
  double apart = 0;
  double all = 0;
  for (std::size_t v = 0; v < own.size(); ++v) {
    apart += glm::length(lent[v] - own[v]);
    all += glm::length(own[v]);
  }
  EXPECT_LT(apart, 0.35 * all);
  EXPECT_FLOAT_EQ(Find(cast, "eyeBlink_L")->lids[0], 1);
}

TEST(ImportedHead, TellsWhatWasMappedAndWhatNot) {
  const std::string text = Text(TheImport().report);
  EXPECT_THAT(text, HasSubstr("ARKit eyeBlinkLeft"));
  EXPECT_THAT(text, HasSubstr("shapes (1 of 6): wibble"));
  EXPECT_THAT(text, HasSubstr("left eye: 84 vertices"));
}

TEST(Landmarks, AreFoundOnTheShowsOwnHead) {
  const face::Cast& cast = DefaultShow().cast;
  const auto marks = FindLandmarks(ShapeOfCast(cast));
  const auto at = [&](std::string_view name) { return LandmarkAt(marks, name).value_or(glm::vec3(9)); };
  const face::LidRig& rig = cast.topology.lids[0];
  const auto margin = static_cast<std::size_t>(rig.margin_ring) * static_cast<std::size_t>(rig.columns);
  const auto& p = cast.faces[0].positions;
  EXPECT_LT(glm::distance(at("left eye, inner corner"), p[rig.upper[margin]]), 0.006F);
  EXPECT_LT(glm::distance(at("left eye, outer corner"),
                          p[rig.upper[margin + static_cast<std::size_t>(rig.columns) - 1]]),
            0.006F);
  const auto points = face::PointsOnFace(cast.net, p);
  const auto point = [&](std::string_view name) {
    const auto found = std::ranges::find(cast.net.points, name, &face::ControlPoint::name);
    return points[static_cast<std::size_t>(found - cast.net.points.begin())];
  };
  EXPECT_LT(glm::distance(at("left mouth corner"), point("MC.l")), 0.009F);
  EXPECT_LT(glm::distance(at("lower lip"), point("LC")), 0.006F);
  EXPECT_LT(glm::distance(at("nose tip"), point("NT")), 0.006F);
  EXPECT_NEAR(at("chin").x, 0, 0.006);
}

TEST(Import, NamesEveryFaultOfEveryFile) {
  const TemporaryFolder folder;
  Model small = ExportedHead();
  WriteGlb(folder.path() / "her.glb", small);
  small.positions.pop_back();
  small.triangles.erase(small.triangles.end() - 30, small.triangles.end());
  small.uv.pop_back();
  small.targets.clear();
  WriteGlb(folder.path() / "less.glb", small);
  const auto made = Import({folder.path() / "her.glb", folder.path() / "less.glb", folder.path() / "none.obj",
                            folder.path() / "him.fbx"},
                           nullptr, {});
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().attempt, HasSubstr("less.glb: "));
  EXPECT_THAT(made.error().attempt, HasSubstr("none.obj: cannot be read"));
  EXPECT_THAT(made.error().attempt, HasSubstr("him.fbx: "));
}

TEST(Import, TellsThatAHeadWithoutShapesHoldsStillAndNamesHeadsApart) {
  const TemporaryFolder folder;
  Model head = ExportedHead();
  head.targets.clear();
  WriteGlb(folder.path() / "her.glb", head);
  const auto made = Import({folder.path() / "her.glb", folder.path() / "her.glb"}, nullptr, {});
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_THAT(Text(made->report), HasSubstr("it has no shapes"));
  EXPECT_EQ(made->heads.cast.faces[1].name, "her-2");
}

TEST(Import, NamesFacesOfTheLookThatTheShowLacks) {
  const TemporaryFolder folder;
  WriteGlb(folder.path() / "her.glb", ExportedHead());
  ImportOptions options;
  options.like = {"kaori", "nobody", "no one"};
  const auto made = Import({folder.path() / "her.glb"}, &DefaultShow(), options);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().attempt, HasSubstr("--like: nobody: the show has no such face"));
  EXPECT_THAT(made.error().attempt, HasSubstr("no one"));
}

// Heads that the project does not hold: a folder that the environment names.
TEST(RealHeads, AreImportedWithAllTheirShapes) {
  const char* folder = std::getenv("KAORI_FACES");
  if (folder == nullptr) GTEST_SKIP() << "KAORI_FACES names no folder with woman.glb and child.glb";
  const std::filesystem::path faces(folder);
  const auto made = Import({faces / "woman.glb", faces / "child.glb"}, &DefaultShow(), {});
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_EQ(made->report.shapes.size(), 52U);
  float mean = 0;
  for (const ReportedShape& shape : made->report.shapes) {
    EXPECT_FALSE(shape.meaning.empty()) << shape.name;
    mean += shape.error.rms_mm / 52;
  }
  EXPECT_LT(mean, 0.7F);
  EXPECT_GT(made->heads.cast.faces[0].eyes[0].radius_m, 0.01F);
  EXPECT_TRUE(Import({faces / "woman.obj"}, nullptr, {}));
}

}  // namespace
}  // namespace kaori::import
