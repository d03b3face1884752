// A face goes out to a modelling tool and comes back as a face of the same cast.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/import/export_head.h"
#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/sculpt.h"
#include "render/face/check.h"
#include "tests/appliance/authoring/sculpt_fixture.h"

namespace kaori::tests {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::size_t kRound = 1;  // The face that goes out.

// What a tool does to a file, line by line; a line that becomes empty is left out.
std::string EachLine(const std::string& text, const std::function<std::string(const std::string&)>& change) {
  std::istringstream lines(text);
  std::string changed;
  for (std::string line; std::getline(lines, line);)
    if (const std::string now = change(line); !now.empty()) changed += now + "\n";
  return changed;
}

// Each position, moved; `within` is the object that it belongs to.
std::string Moved(const std::string& text,
                  const std::function<glm::vec3(const glm::vec3& p, const std::string& within)>& move) {
  std::string object;
  return EachLine(text, [&](const std::string& line) {
    if (line.starts_with("o ")) object = line.substr(2);
    if (!line.starts_with("v ")) return line;
    std::istringstream numbers(line.substr(2));
    glm::vec3 p{};
    numbers >> p.x >> p.y >> p.z;
    p = move(p, object);
    return fmt::format("v {:.6f} {:.6f} {:.6f}", p.x, p.y, p.z);
  });
}

// The default show with one more face, "tom", which was made of the round one.
class ShowWithTom : public ShowCopy {
 public:
  explicit ShowWithTom(const std::string& obj, const std::string& recipe = "mesh = \"tom.obj\"\n") {
    std::ofstream(folder() / "faces" / "tom.obj") << obj;
    std::ofstream(folder() / "faces" / "tom.toml") << "shape = \"modelled\"\n" << recipe;
    Replace("faces/cast.toml", "\"robot\"]", "\"robot\", \"tom\"]");
  }

  face::Cast Cast() const {
    face::Cast cast;
    const auto done = sculpt::Sculpt(folder(), cast);
    if (!done) ADD_FAILURE() << done.error().message();
    return cast;
  }
  face::Face Tom() const { return Cast().faces.back(); }
};

std::string Exported() {
  return import::ObjOfFace(SculptedCast(), kRound);
}

// But for the last ring behind the lids, which lies in the ball: it may come back deeper, and no less deep.
float FarthestApart_mm(const face::Face& came_back, const face::Face& went_out) {
  const sculpt::Cage cage = sculpt::BuildCage();
  float most_m = 0;
  for (face::Index v = 0; v < came_back.positions.size(); ++v) {
    const glm::vec3 &now = came_back.positions[v], &before = went_out.positions[v];
    const bool in_ball = cage.key(v).region == sculpt::Region::kEye && cage.key(v).b > sculpt::kLidRing + 1;
    const glm::vec3& ball = went_out.eyes[before.x > 0 ? 0 : 1].centre;
    const float off_m = glm::distance(now, before);
    if (!in_ball || glm::distance(now, ball) > glm::distance(before, ball)) most_m = std::max(most_m, off_m);
  }
  return 1000 * most_m;
}

TEST(ModelledHead, ThatNobodyChangedIsTheFaceThatWentOut) {
  const face::Cast cast = ShowWithTom(Exported()).Cast();
  const face::Face& round = SculptedCast().faces[kRound];
  const face::Face& tom = cast.faces.back();
  EXPECT_EQ(tom.name, "tom");
  EXPECT_LT(FarthestApart_mm(tom, round),
            0.5F);  // A carved fold over an eye may be deeper than a ball allows.
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_NEAR(tom.eyes[side].radius_m, round.eyes[side].radius_m, 1e-5);
    EXPECT_NEAR(tom.eyes[side].lid_thickness_m, round.eyes[side].lid_thickness_m, 1e-5);
    EXPECT_LT(glm::distance(tom.eyes[side].centre, round.eyes[side].centre), 1e-5);
  }
  EXPECT_THAT(face::FindFaults(cast), IsEmpty());
}

TEST(ModelledHead, IsWrittenInQuadsThatShareTheirPositions) {
  std::size_t quads = 0, triangles = 0, positions = 0, within_eyes = 0;
  bool in_eye = false;
  EachLine(Exported(), [&](const std::string& line) {
    if (line.starts_with("o ")) in_eye = line.starts_with("o eye_");
    const auto corners = std::ranges::count(line, '/');
    if (line.starts_with("f ") && in_eye) ++within_eyes;
    if (line.starts_with("f ") && !in_eye) ++(corners == 4 ? quads : triangles);
    if (line.starts_with("v ") && !in_eye) ++positions;
    return line;
  });
  EXPECT_EQ(quads, 2690U);  // As sculpt::BuildCage says of the cage.
  EXPECT_EQ(triangles, 6U);
  EXPECT_GT(within_eyes, 500U);
  EXPECT_LT(positions, SculptedCast().topology.vertex_count);
}

TEST(ModelledHead, KeepsTwoSidesThatDiffer) {
  const face::Face tom = ShowWithTom(Moved(Exported(), [](glm::vec3 p, const std::string&) {
                           if (p.x > 0.03F && p.y < -0.03F) p.x += 0.01F;
                           return p;
                         })).Tom();
  const face::Face& round = SculptedCast().faces[kRound];
  int left = 0, right = 0;
  for (std::size_t v = 0; v < tom.positions.size(); ++v) {
    const float moved_m = glm::distance(tom.positions[v], round.positions[v]);
    if (moved_m > 0.005F) ++(round.positions[v].x > 0 ? left : right);
  }
  EXPECT_GT(left, 50);
  EXPECT_EQ(right, 0);
}

TEST(ModelledHead, HasItsTeethWhereItsMouthIs) {
  const face::Face round = ShowWithTom(Exported()).Tom();
  const face::Face tom = ShowWithTom(Moved(Exported(), [](const glm::vec3& p, const std::string&) {
                           return p + glm::vec3(0, -0.01F, 0.02F);
                         })).Tom();
  EXPECT_NEAR(tom.mouth.offset.y - round.mouth.offset.y, -0.01F, 1e-5);
  EXPECT_NEAR(tom.mouth.offset.z - round.mouth.offset.z, 0.02F, 1e-5);
  EXPECT_NEAR(tom.mouth.scale, round.mouth.scale, 1e-5);
  EXPECT_NEAR(tom.eyes[0].centre.y - round.eyes[0].centre.y, -0.01F, 1e-5);
}

TEST(ModelledHead, ItsRecipeMovesTheTeethFromThere) {
  const face::Face tom =
      ShowWithTom(Exported(), "mesh = \"tom.obj\"\n[mouth_fit]\nteeth_offset = [0, 0.5, 0]\n").Tom();
  EXPECT_NEAR(tom.mouth.offset.y - ShowWithTom(Exported()).Tom().mouth.offset.y, 0.005F, 1e-6);
}

TEST(ModelledHead, ItsLidsAreAsThickAsItsRecipeSays) {
  const face::Face tom = ShowWithTom(Exported(), "mesh = \"tom.obj\"\n[eye]\nthickness = 0.2\n").Tom();
  EXPECT_NEAR(tom.eyes[0].lid_thickness_m, 0.002F, 1e-6);
}

// A ball that somebody has made larger is no reason for lids without an edge.
TEST(ModelledHead, ItsLidsStandOverABallThatWasMadeLarger) {
  const face::EyeBall round = SculptedCast().faces[kRound].eyes[0];
  const face::Face tom = ShowWithTom(Moved(Exported(), [&](glm::vec3 p, const std::string& within) {
                           return within == "eye_left" ? round.centre + (p - round.centre) * 1.1F : p;
                         })).Tom();
  EXPECT_NEAR(tom.eyes[0].radius_m, 1.1F * round.radius_m, 1e-5);
  EXPECT_NEAR(tom.eyes[0].lid_thickness_m, 0.0008F, 1e-6);
}

// A tool may write vertices in any order, and all as one object.
TEST(ModelledHead, IsKnownByItsTextureMapWhateverTheOrderOfItsVertices) {
  std::vector<std::string> positions;
  std::string rest;
  EachLine(Exported(), [&](const std::string& line) {
    if (line.starts_with("v ")) positions.push_back(line);
    if (line.starts_with("vt ")) rest += line + "\n";
    return line;
  });
  std::ranges::reverse(positions);
  std::string mixed;
  for (const std::string& line : positions) mixed += line + "\n";
  mixed += rest;
  mixed += EachLine(Exported(), [&](const std::string& line) {
    if (!line.starts_with("f ")) return std::string();
    std::istringstream corners(line.substr(2));
    std::string turned = "f";
    for (std::string corner; corners >> corner;) {
      const auto slash = corner.find('/');
      turned += fmt::format(" {}{}", positions.size() + 1 - std::stoul(corner.substr(0, slash)),
                            corner.substr(slash));
    }
    return turned;
  });
  EXPECT_LT(FarthestApart_mm(ShowWithTom(mixed).Tom(), SculptedCast().faces[kRound]), 0.5F);
}

TEST(ModelledHead, WithAnotherTextureMapIsRefused) {
  const std::string other = EachLine(Exported(), [](const std::string& line) {
    return line.starts_with("vt 0.3") ? "vt 0.999 0.999" : line;
  });
  EXPECT_THAT(ShowWithTom(other).Complaint(),
              HasSubstr("vertices of the cast's mesh are not in its texture map"));
}

TEST(ModelledHead, WithoutAnEyeballOrWithAFlatOneIsRefused) {
  std::string object;
  const std::string blind = EachLine(Exported(), [&](const std::string& line) {
    if (line.starts_with("o ")) object = line;
    return object == "o eye_right" && line.starts_with("f ") ? std::string() : line;
  });
  EXPECT_THAT(ShowWithTom(blind).Complaint(), HasSubstr("tom.obj: the right eyeball is missing"));
  const std::string flat = Moved(Exported(), [](glm::vec3 p, const std::string& within) {
    if (within == "eye_left") p.z *= 0.5F;
    return p;
  });
  EXPECT_THAT(ShowWithTom(flat).Complaint(), HasSubstr("the left eyeball is"));
}

TEST(ModelledHead, NamesAFileThatIsNotThereOrLiesElsewhere) {
  EXPECT_THAT(ShowWithTom(Exported(), "mesh = \"tim.obj\"\n").Complaint(),
              HasSubstr("tim.obj: cannot be read: No such file"));
  EXPECT_THAT(ShowWithTom(Exported(), "mesh = \"../tom.obj\"\n").Complaint(),
              HasSubstr("tom.toml:2: mesh: must be the name of a file beside this one"));
  EXPECT_THAT(ShowWithTom("o nothing\n").Complaint(), HasSubstr("tom.obj"));
}

}  // namespace
}  // namespace kaori::tests
