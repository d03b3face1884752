#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "appliance/authoring/model/gltf_file.h"
#include "appliance/authoring/model/mesh_check.h"
#include "appliance/authoring/model/obj_file.h"
#include "tests/appliance/authoring/import_glb.h"

namespace kaori::model {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const ReadBeside kNothingBeside = [](const std::string&) { return std::nullopt; };

std::optional<Model> Read(const GlbMaker& maker, Findings& findings) {
  return ReadGltf("test.glb", maker.Glb(), kNothingBeside, findings);
}

std::optional<Model> ReadText(const std::string& text, Findings& findings) {
  return ReadObj("test.obj", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, findings);
}

Model PlateWithTarget() {
  Model plate = Plate(4, false);
  plate.targets.push_back(
      {"jawOpen", std::vector<glm::vec3>(plate.positions.size(), glm::vec3(0, -0.01F, 0))});
  return plate;
}

TEST(Gltf, GivesBackWhatWasWritten) {
  const Model plate = PlateWithTarget();
  GlbMaker maker;
  maker.AddModel(plate, "plate");
  Findings findings;
  const auto read = Read(maker, findings);
  ASSERT_TRUE(read) << testing::PrintToString(findings.lines());
  EXPECT_EQ(read->positions, plate.positions);
  EXPECT_EQ(read->triangles, plate.triangles);
  ASSERT_THAT(read->targets, SizeIs(1));
  EXPECT_EQ(read->targets[0].name, "jawOpen");
  EXPECT_EQ(read->targets[0].offsets, plate.targets[0].offsets);
  for (std::size_t v = 0; v < plate.uv.size(); ++v) EXPECT_NEAR(read->uv[v].y, plate.uv[v].y, 1e-6);
}

TEST(Gltf, PlacesMeshesAsTheirNodesDo) {
  Model plate = PlateWithTarget();
  GlbMaker maker;
  maker.AddModel(plate, "plate");
  maker.AddNode("{\"children\":[2],\"translation\":[1,0,0]}");
  maker.AddNode("{\"mesh\":0,\"rotation\":[0,0,0.70710678,0.70710678],\"scale\":[2,2,2]}");
  maker.AddToDocument("\"x\":0");
  Findings findings;
  const auto read = Read(maker, findings);
  ASSERT_TRUE(read);
  // The second use: turned a quarter about z, twice as large, moved along x.
  const std::size_t count = plate.positions.size();
  ASSERT_THAT(read->positions, SizeIs(2 * count));
  EXPECT_NEAR(read->positions[count + 4].x, 1, 1e-5);
  EXPECT_NEAR(read->positions[count + 4].y, 0.2, 1e-5);
  EXPECT_NEAR(read->targets[0].offsets[count].x, 0.02, 1e-6);
}

TEST(Gltf, JoinsTargetsOfEqualNameInSeveralMeshes) {
  GlbMaker maker;
  maker.AddModel(PlateWithTarget(), "face");
  maker.AddModel(PlateWithTarget(), "teeth");
  Findings findings;
  const auto read = Read(maker, findings);
  ASSERT_TRUE(read);
  ASSERT_THAT(read->targets, SizeIs(1));
  EXPECT_EQ(read->targets[0].offsets.size(), read->positions.size());
  EXPECT_EQ(read->targets[0].offsets.back(), glm::vec3(0, -0.01F, 0));
  ASSERT_THAT(read->meshes, SizeIs(2));
  EXPECT_EQ(read->meshes[1].name, "teeth");
}

TEST(Gltf, ReadsQuantisedPositionsAndSparseTargets) {
  GlbMaker maker;
  const std::vector<std::int16_t> positions{0, 0, 0, 0, 1000, 0, 0, 0, 0, 1000, 0, 0};
  const int at = maker.AddAccessor(maker.AddView(BytesOf(positions), 8), Component::kInt16, 3, "VEC3");
  const std::vector<std::uint16_t> uv{0, 65535, 65535, 65535, 0, 0};
  const int places =
      maker.AddAccessor(maker.AddView(BytesOf(uv)), Component::kUint16, 3, "VEC2", "\"normalized\":true");
  const int rows = maker.AddView(BytesOf<std::uint16_t>({2}));
  const int values = maker.AddView(BytesOf<std::int16_t>({0, 500, 0}));
  const std::string sparse = fmt::format(
      "\"sparse\":{{\"count\":1,\"indices\":{{\"bufferView\":{},\"componentType\":5123}},\"values\":{{"
      "\"bufferView\":{}}}}}",
      rows, values);
  const int target = maker.AddAccessor(-1, Component::kInt16, 3, "VEC3", sparse);
  const int corners = maker.AddAccessor(maker.AddView({0, 1, 2}), Component::kUint8, 3, "SCALAR");
  maker.AddMesh(
      fmt::format("{{\"primitives\":[{{\"attributes\":{{\"POSITION\":{},\"TEXCOORD_0\":{}}},\"indices\":{},"
                  "\"targets\":[{{\"POSITION\":{}}}]}}]}}",
                  at, places, corners, target));
  maker.AddNode("{\"mesh\":0,\"scale\":[0.0001,0.0001,0.0001]}");
  maker.AddToDocument(
      "\"extensionsRequired\":[\"KHR_mesh_quantization\"],\"extensionsUsed\":[\"KHR_mesh_quantization\"]");
  Findings findings;
  const auto read = Read(maker, findings);
  ASSERT_TRUE(read) << testing::PrintToString(findings.lines());
  EXPECT_NEAR(read->positions[1].x, 0.1, 1e-6);
  EXPECT_NEAR(read->uv[2].y, 1, 1e-6);
  EXPECT_NEAR(read->targets[0].offsets[2].y, 0.05, 1e-6);
  EXPECT_EQ(read->targets[0].offsets[0], glm::vec3(0));
}

TEST(Gltf, ReadsPresetsOfBothVrms) {
  GlbMaker maker;
  maker.AddModel(PlateWithTarget(), "face");
  maker.AddToDocument(
      "\"extensions\":{\"VRM\":{\"blendShapeMaster\":{\"blendShapeGroups\":[{\"name\":\"A\",\"presetName\":"
      "\"a\",\"binds\":[{"
      "\"mesh\":0,\"index\":0,\"weight\":50}]}]}},\"VRMC_vrm\":{\"expressions\":{\"preset\":{\"aa\":{"
      "\"morphTargetBinds\":[{"
      "\"node\":0,\"index\":0,\"weight\":0.25}]}}}}}");
  Findings findings;
  const auto read = Read(maker, findings);
  ASSERT_TRUE(read);
  ASSERT_THAT(read->presets, SizeIs(2));
  EXPECT_EQ(read->presets[0].name, "a");
  EXPECT_FLOAT_EQ(read->presets[0].parts.at(0).weight, 0.5F);
  EXPECT_EQ(read->presets[1].name, "aa");
  EXPECT_FLOAT_EQ(read->presets[1].parts.at(0).weight, 0.25F);
}

TEST(Gltf, RefusesEveryTruncatedFileWithItsName) {
  GlbMaker maker;
  maker.AddModel(Plate(1, false), "plate");
  const std::vector<std::uint8_t> whole = maker.Glb();
  for (std::size_t bytes = 0; bytes < whole.size(); bytes += 7) {
    Findings findings;
    const auto read = ReadGltf("short.glb", std::span(whole).first(bytes), kNothingBeside, findings);
    EXPECT_FALSE(read) << bytes;
    ASSERT_FALSE(findings.empty()) << bytes;
    EXPECT_THAT(findings.lines()[0], ::testing::StartsWith("short.glb: ")) << bytes;
  }
}

TEST(Gltf, NamesEveryFaultAtOnce) {
  Model bare = Plate(2, false);
  bare.uv.clear();
  Model wrong = Plate(2, false);
  wrong.triangles[0][0] = 99;
  GlbMaker maker;
  maker.AddModel(bare, "bare");
  maker.AddModel(wrong, "wrong");
  Findings findings;
  EXPECT_FALSE(Read(maker, findings));
  EXPECT_THAT(findings.lines(),
              ElementsAre(HasSubstr("mesh \"bare\": has no texture coordinates"),
                          HasSubstr("mesh \"wrong\": 1 corners name vertices that do not exist")));
}

// The third primitive has the first one's vertices: behind them lie those of the second.
TEST(Gltf, RefusesACornerBeyondItsOwnVerticesThoughOthersFollow) {
  const Model plate = Plate(1, false);
  for (const Index corner : {3U, 4U}) {
    GlbMaker maker;
    std::array<std::string, 2> vertices;
    for (std::string& set : vertices)
      set = fmt::format("\"attributes\":{{\"POSITION\":{},\"TEXCOORD_0\":{}}}",
                        maker.AddVec3(plate.positions), maker.AddVec2(plate.uv));
    const int whole = maker.AddIndices(plate.triangles), one = maker.AddIndices({{0, 1, corner}});
    maker.AddMesh(
        fmt::format("{{\"name\":\"three\",\"primitives\":[{{{0},\"indices\":{2}}},{{{1},\"indices\":{2}}},{{{"
                    "0},\"indices\":{3}}}]}}",
                    vertices[0], vertices[1], whole, one));
    maker.AddNode("{\"mesh\":0}");
    Findings findings;
    const auto read = Read(maker, findings);
    EXPECT_EQ(read.has_value(), corner < plate.positions.size());
    if (read) {
      EXPECT_EQ(read->triangles.back(), (Triangle{0, 1, 3}));
    } else {
      EXPECT_THAT(findings.lines(),
                  ElementsAre(HasSubstr("mesh \"three\": 1 corners name vertices that do not exist")));
    }
  }
}

TEST(Gltf, SaysThatATextureIsMissing) {
  GlbMaker maker;
  maker.AddModel(Plate(1, false), "plate");
  maker.AddToDocument(
      "\"materials\":[{\"name\":\"skin\",\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
      "\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"gone.png\"}]");
  Findings findings;
  Read(maker, findings);
  ASSERT_THAT(findings.lines(), SizeIs(1));
  EXPECT_THAT(findings.lines()[0], HasSubstr("texture is missing"));
}

TEST(Obj, GivesOneVertexForEachPairOfPlaceAndTexture) {
  const std::string text =
      "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\n"
      "f 1/1 2/2 3/3 4/4\nf -4/5 2/2 3/3\n";
  Findings findings;
  const auto read = ReadText(text, findings);
  ASSERT_TRUE(read) << testing::PrintToString(findings.lines());
  EXPECT_THAT(read->positions, SizeIs(5));
  EXPECT_THAT(read->triangles, SizeIs(3));
  EXPECT_EQ(read->positions[0], read->positions[1]);  // The first position has two texture coordinates.
}

TEST(Obj, KeepsTheOrderOfTheFile) {
  const Model plate = Plate(3, true);
  Findings findings;
  const auto read = ReadText(ObjText(plate), findings);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->triangles, plate.triangles);
  ASSERT_EQ(read->positions.size(), plate.positions.size());
}

TEST(Obj, RefusesFacesWithoutTexture) {
  Findings findings;
  EXPECT_FALSE(ReadText("v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nf 1 2 3\n", findings));
  EXPECT_THAT(findings.lines(), ElementsAre(HasSubstr("3 corners have no texture coordinate")));
}

TEST(Obj, RefusesALineThatWouldTakeHoursToCut) {
  std::string text = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nvt 0 0\nf";
  for (int i = 0; i < 100'000; ++i) text += fmt::format(" {}/1", i % 3 + 1);
  Findings findings;
  EXPECT_FALSE(ReadText(text, findings));
  EXPECT_THAT(findings.lines(), ElementsAre(HasSubstr("line 5: has more than")));
}

TEST(Obj, RefusesAWordThatIsNoNumber) {
  Findings findings;
  EXPECT_FALSE(ReadText("v 0 0 0\nv 0.1 nan 0\nv 0.1 0.1 0\nvt 0 0\nf 1/1 2/1 3/1\n", findings));
  EXPECT_THAT(findings.lines(), ElementsAre(HasSubstr("line 2: holds a word that is no number")));
}

TEST(MeshCheck, FindsNumbersThatAreNone) {
  Model plate = PlateWithTarget();
  plate.positions[3].x = std::numeric_limits<float>::quiet_NaN();
  plate.targets[0].offsets[1].y = std::numeric_limits<float>::infinity();
  Findings findings;
  CheckModel(plate, findings);
  EXPECT_THAT(findings.lines(), ElementsAre("plate: positions: 1 of 25 are no numbers",
                                            "plate: target \"jawOpen\": 1 of 25 are no numbers"));
}

TEST(MeshCheck, FindsAHeadThatIsNotInMetres) {
  Model plate = Plate(2, false);
  for (glm::vec3& p : plate.positions) p *= 100.0F;
  Findings findings;
  CheckModel(plate, findings);
  EXPECT_THAT(findings.lines(), ElementsAre("plate: is 10 m large; a head in metres is expected"));
}

TEST(MeshCheck, FindsTrianglesThatAreFlatOrTurnedOver) {
  Model plate = Plate(2, false);
  std::swap(plate.uv[0], plate.uv[1]);
  plate.uv[8] = plate.uv[7];
  Findings findings;
  CheckUnfolding(plate, plate.triangles, findings);
  EXPECT_THAT(findings.lines(), ElementsAre(HasSubstr("without area in the texture: 1 of 8"),
                                            HasSubstr("turned over in the texture")));
}

TEST(MeshCheck, FindsAnotherTopology) {
  const Model plate = Plate(2, false);
  Model other = plate;
  other.file = "other";
  std::swap(other.triangles[0], other.triangles[1]);
  Findings findings;
  CheckSameTopology(plate, Plate(3, false), findings);
  CheckSameTopology(plate, other, findings);
  EXPECT_THAT(findings.lines(),
              ElementsAre("plate: 16 vertices, plate has 9", HasSubstr("other: its triangles join other")));
}

}  // namespace
}  // namespace kaori::model
