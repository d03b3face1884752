// Hair, teeth and clothes: sound meshes, turned outwards, with nothing of a neck left to see.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/shaping.h"
#include "appliance/authoring/appearance/skull.h"
#include "appliance/authoring/appearance/torso.h"
#include "tests/appliance/authoring/appearance_fixture.h"

namespace kaori::appearance {
namespace {

using face::Part;
using face::Prop;

// Positive where triangles wind outwards, for a mesh that is closed or nearly.
double SignedVolume_m3(const Prop& prop) {
  glm::dvec3 middle(0);
  for (const auto& v : prop.vertices)
    middle += glm::dvec3(v.position) / static_cast<double>(prop.vertices.size());
  double volume = 0;
  for (const auto& t : prop.triangles) {
    const auto corner = [&](int i) {
      return glm::dvec3(prop.vertices[t[static_cast<std::size_t>(i)]].position) - middle;
    };
    volume += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6;
  }
  return volume;
}

bool HasPart(const face::Face& face, Part part) {
  return std::any_of(face.props.begin(), face.props.end(),
                     [&](int p) { return DressedCast().props[static_cast<std::size_t>(p)].part == part; });
}

TEST(AppearanceProps, AreFiniteWithUnitNormalsAndTangents) {
  for (const Prop& prop : DressedCast().props) {
    for (const auto& v : prop.vertices) {
      ASSERT_TRUE(std::isfinite(v.position.x + v.position.y + v.position.z)) << prop.name;
      ASSERT_NEAR(glm::length(v.normal), 1, 1e-3) << prop.name;
      ASSERT_NEAR(glm::length(v.tangent), 1, 1e-3) << prop.name;
    }
  }
}

TEST(AppearanceProps, HaveTrianglesOfThreeDifferentVerticesThatExist) {
  for (const Prop& prop : DressedCast().props) {
    for (const auto& t : prop.triangles) {
      ASSERT_LT(std::max({t[0], t[1], t[2]}), prop.vertices.size()) << prop.name;
      ASSERT_TRUE(t[0] != t[1] && t[1] != t[2] && t[0] != t[2]) << prop.name;
    }
  }
}

TEST(AppearanceProps, WindOutwards) {
  for (const Prop& prop : DressedCast().props) {
    if (prop.part == Part::kUpperTeeth || prop.part == Part::kLowerTeeth)
      continue;  // Open sheets: see below.
    EXPECT_GT(SignedVolume_m3(prop), 0) << prop.name;
  }
}

TEST(AppearanceProps, TurnTeethTowardsTheAudience) {
  for (const Prop& prop : DressedCast().props) {
    if (prop.part != Part::kUpperTeeth && prop.part != Part::kLowerTeeth) continue;
    glm::vec3 mean(0);
    for (const auto& v : prop.vertices) mean += v.normal;
    EXPECT_GT(mean.z, 0) << prop.name;
  }
}

TEST(AppearanceProps, CarryShadeBetweenNothingAndOne) {
  for (const Prop& prop : DressedCast().props) {
    const auto [low, high] =
        std::minmax_element(prop.vertices.begin(), prop.vertices.end(),
                            [](const auto& a, const auto& b) { return a.shade < b.shade; });
    EXPECT_GE(low->shade, 0) << prop.name;
    EXPECT_LE(high->shade, 1) << prop.name;
    EXPECT_GT(high->shade - low->shade, 0.05F) << prop.name;  // Something is shaded at all.
  }
}

TEST(AppearanceFaces, WearWhatBecomesThem) {
  for (const face::Face& face : DressedCast().faces) {
    const bool covered = face.name != "dog" && face.name != "kettle";
    EXPECT_EQ(HasPart(face, Part::kHair), covered) << face.name;
    EXPECT_EQ(HasPart(face, Part::kClothes), face.name != "kettle") << face.name;
    EXPECT_TRUE(HasPart(face, Part::kUpperTeeth)) << face.name;
  }
}

TEST(AppearanceFaces, AreShadedBetweenNothingAndOneAndLighterOnTheNoseThanUnderTheChin) {
  for (const face::Face& face : DressedCast().faces) {
    ASSERT_EQ(face.occlusion.size(), DressedCast().topology.vertex_count) << face.name;
    const auto [low, high] = std::minmax_element(face.occlusion.begin(), face.occlusion.end());
    EXPECT_GE(*low, 0);
    EXPECT_LE(*high, 1);
    EXPECT_LT(*low, 0.6F);
    EXPECT_GT(*high, 0.8F);
  }
}

TEST(AppearanceFaces, HaveTheSameShadeOnBothSidesOfASeam) {
  const auto& twin = DressedCast().topology.twin;
  for (const face::Face& face : DressedCast().faces) {
    for (std::size_t i = 0; i < twin.size(); ++i) ASSERT_FLOAT_EQ(face.occlusion[i], face.occlusion[twin[i]]);
  }
}

// The neck's open end lies inside the cloth: seen from every side, cloth is further out at its height.
TEST(AppearanceClothes, HideTheEndOfEveryNeck) {
  for (const face::Face& face : DressedCast().faces) {
    if (!HasPart(face, Part::kClothes)) continue;
    float neck_radius_m = 0;
    for (const auto& p : face.positions) {
      if (p.y < -0.162F) neck_radius_m = std::max(neck_radius_m, std::abs(p.x));
    }
    float cloth_radius_m = 0;
    float cloth_top_m = -1;
    for (const int index : face.props) {
      const Prop& prop = DressedCast().props[static_cast<std::size_t>(index)];
      if (prop.part != Part::kClothes) continue;
      for (const auto& v : prop.vertices) {
        cloth_top_m = std::max(cloth_top_m, v.position.y);
        if (std::abs(v.position.y + 0.17F) < 0.01F)
          cloth_radius_m = std::max(cloth_radius_m, std::abs(v.position.x));
      }
    }
    EXPECT_GT(cloth_radius_m, neck_radius_m) << face.name;
    EXPECT_GT(cloth_top_m, -0.145F) << face.name;
  }
}

TEST(AppearanceSkull, LaysHairOutsideItself) {
  const Skull skull;
  for (float around = 0; around < 360; around += 15) {
    for (float t = 0; t <= 1; t += 0.1F) {
      const glm::vec3 q = (OnFall(skull, {}, around, t) - skull.centre_cm) / skull.radii_cm;
      if (OnFall(skull, {}, around, t).y < skull.centre_cm.y) continue;
      EXPECT_GT(glm::length(q), 1) << around << " " << t;
    }
  }
}

TEST(AppearanceShaping, TablesPassThroughTheirKnotsWithoutOvershoot) {
  constexpr glm::vec2 kKnots[] = {{0, 1}, {1, 3}, {2, 3}, {5, -1}};
  for (const glm::vec2 knot : kKnots) EXPECT_NEAR(Table(kKnots, knot.x), knot.y, 1e-5);
  for (float x = -1; x < 6; x += 0.05F) {
    EXPECT_LE(Table(kKnots, x), 3.0001F);
    EXPECT_GE(Table(kKnots, x), -1.0001F);
  }
}

}  // namespace
}  // namespace kaori::appearance
