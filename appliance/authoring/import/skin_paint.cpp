#include "appliance/authoring/import/skin_paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/import/paint_uvs.h"
#include "appliance/authoring/import/raster.h"

namespace kaori::import {
namespace {

// Enough for one colour, and for paint that was made at the show's size and is shown on another head.
constexpr int kSide_px = 1024;
// In shares: triangles are drawn this much beyond their edges, so that filtering at a seam meets
// paint, not ground.
constexpr float kMargin = -0.15F;
// A triangle whose middle is farther from an opening has no pixel that the lids' paint reaches.
constexpr float kLidsReach_m = 0.02F;
// Of the show's texture's side: corners farther apart lie on both sides of its seam, and what is between them
// is none of the face.
constexpr float kFarthestApart = 0.08F;

using Colour = PaintColour;
constexpr Colour kSkin{222, 184, 163, 40};
constexpr Colour kInsideOfMouth{112, 44, 46, 110};
constexpr Colour kTeeth{232, 226, 212, 150};
constexpr Colour kTongue{186, 92, 92, 120};

// Calls paint(x, y, shares) for each pixel of a triangle of texture coordinates (v up), kMargin beyond its
// edges; shares may be negative there. Rows run down; coordinates beyond 0..1 are not repeated.
template <class Paint>
void ForPixels(const std::array<glm::vec2, 3>& uv, Paint paint) {
  const auto pixel = [](const glm::vec2& p) {
    return glm::vec2(p.x, 1 - p.y) * static_cast<float>(kSide_px);
  };
  ForCells({pixel(uv[0]), pixel(uv[1]), pixel(uv[2])}, kSide_px, [&](int x, int y, const glm::vec3& shares) {
    if (std::min({shares.x, shares.y, shares.z}) > kMargin) paint(x, y, shares);
  });
}

// The nearest pixel, with v up; beyond the edges, the edge.
Colour At(const face::Texture& texture, const glm::vec2& uv) {
  const auto along = [](float t, int size_px) {
    return std::clamp(static_cast<int>(t * static_cast<float>(size_px)), 0, size_px - 1);
  };
  const int x = along(uv.x, texture.width_px);
  const int y = along(1 - uv.y, texture.height_px);
  const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(texture.width_px) +
                       static_cast<std::size_t>(x));
  return {texture.rgba[at], texture.rgba[at + 1], texture.rgba[at + 2], texture.rgba[at + 3]};
}

// A picture in work, of one colour at first.
class Painting {
 public:
  explicit Painting(const Colour& ground) : ground_(ground), texture_{kSide_px, kSide_px, {}} {
    for (int i = 0; i < kSide_px * kSide_px; ++i)
      texture_.rgba.own().insert(texture_.rgba.own().end(), ground.begin(), ground.end());
  }

  void Fill(const std::array<glm::vec2, 3>& uv, const Colour& colour) {
    ForPixels(uv, [&](int x, int y, const glm::vec3&) { Put(x, y, colour); });
  }

  // Mixes `source` in, as much as `shown` says at the corners.
  void Copy(const std::array<glm::vec2, 3>& uv, const std::array<glm::vec2, 3>& from, const glm::vec3& shown,
            const face::Texture& source) {
    ForPixels(uv, [&](int x, int y, const glm::vec3& s) {
      const Colour paint = At(source, s.x * from[0] + s.y * from[1] + s.z * from[2]);
      Put(x, y, MixPaint(ground_, paint, std::clamp(glm::dot(s, shown), 0.0F, 1.0F)));
    });
  }

  // Changes what is painted: change(colour, shares) gives the new colour of a pixel.
  template <class Change>
  void Repaint(const std::array<glm::vec2, 3>& uv, Change change) {
    ForPixels(uv, [&](int x, int y, const glm::vec3& s) { Put(x, y, change(Get(x, y), s)); });
  }

  face::Texture Release() { return std::move(texture_); }

 private:
  static std::ptrdiff_t PixelAt(int x, int y) { return 4 * (static_cast<std::ptrdiff_t>(y) * kSide_px + x); }
  void Put(int x, int y, const Colour& colour) {
    std::ranges::copy(colour, texture_.rgba.own().begin() + PixelAt(x, y));
  }
  Colour Get(int x, int y) {
    Colour colour{};
    std::copy_n(texture_.rgba.own().begin() + PixelAt(x, y), colour.size(), colour.begin());
    return colour;
  }
  Colour ground_;
  face::Texture texture_;
};

// Whether a triangle of the head, laid on the show's texture, runs across that one's seam.
bool AreApart(const std::array<glm::vec2, 3>& uvs) {
  const auto far = [](const glm::vec2& a, const glm::vec2& b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) > kFarthestApart;
  };
  return far(uvs[0], uvs[1]) || far(uvs[1], uvs[2]) || far(uvs[2], uvs[0]);
}

template <class Value>
std::array<glm::vec2, 3> Corners(const Triangle& t, Value value) {
  return {value(t[0]), value(t[1]), value(t[2])};
}

// How much of the show's paint is used at a point of its first face (metres, origin between the eyes): all of
// it between temples, hairline and chin, none where hair is painted, on ears and neck. The bounds are read
// off the cast's own woman.
float ShownAt(const glm::vec3& p) {
  const float aside = glm::smoothstep(0.050F, 0.066F, std::abs(p.x));
  const float above = glm::smoothstep(0.028F, 0.042F, p.y);
  const float below = glm::smoothstep(0.088F, 0.106F, -p.y);
  const float behind = glm::smoothstep(0.0F, 0.02F, -p.z);
  return 1 - std::max({aside, above, below, behind});
}

// What the show's paint looks like where it fades: the median of each channel, which a few dark hairs do not
// draw down. kSkin where it fades nowhere.
Colour GroundOf(const std::vector<Colour>& paints) {
  Colour ground = kSkin;
  if (paints.empty()) return ground;
  for (std::size_t channel = 0; channel < ground.size(); ++channel) {
    std::vector<std::uint8_t> values;
    for (const Colour& paint : paints) values.push_back(paint[channel]);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    ground[channel] = *middle;
  }
  return ground;
}

// Pixels at the triangles' margins are painted over by each that has them, which changes little where all
// agree.
void PaintLids(const Heads& heads, const LidPaint& lids, const Colour& ground, Painting& painting) {
  const LidColours colours{
      .skin = ground, .liner = {58, 36, 32, 40}, .rim = MixPaint(ground, {150, 84, 72, 90}, 0.6F)};
  const auto& at = heads.heads.front().positions;
  for (const Triangle& t : heads.triangles) {
    if (heads.part[t[0]] != PartOf::kSkin) continue;
    const auto near = lids.DistanceOf((at[t[0]] + at[t[1]] + at[t[2]]) / 3.0F);
    if (!near || *near > kLidsReach_m) continue;
    painting.Repaint(Corners(t, [&](Index v) { return heads.uv[v]; }),
                     [&](const Colour& under, const glm::vec3& s) {
                       return lids.Over(under, s.x * at[t[0]] + s.y * at[t[1]] + s.z * at[t[2]], colours);
                     });
  }
}

// Softly from the lips on, since a lip turns inwards.
void PaintInsideOfMouth(const Heads& heads, const std::vector<bool>& inside, Painting& painting) {
  // Without known lips nothing is told apart, and the inside stays as it is.
  if (inside.empty()) return;
  for (const Triangle& t : heads.triangles) {
    const glm::vec3 share(inside[t[0]], inside[t[1]], inside[t[2]]);
    if (heads.part[t[0]] != PartOf::kSkin || share == glm::vec3(0)) continue;
    painting.Repaint(Corners(t, [&](Index v) { return heads.uv[v]; }),
                     [&](const Colour& under, const glm::vec3& s) {
                       return MixPaint(under, kInsideOfMouth, std::clamp(glm::dot(s, share), 0.0F, 1.0F));
                     });
  }
}

// Last, over what the skin's margins have painted beyond their triangles.
void FillMouth(const Heads& heads, Painting& painting) {
  for (const Triangle& t : heads.triangles) {
    const PartOf part = heads.part[t[0]];
    if (part == PartOf::kSkin) continue;
    painting.Fill(Corners(t, [&](Index v) { return heads.uv[v]; }),
                  part == PartOf::kTongue ? kTongue : kTeeth);
  }
}

}  // namespace

face::Texture PlainSkin(const Heads& heads) {
  Painting painting(kSkin);
  FillMouth(heads, painting);
  return painting.Release();
}

// One for each skin vertex: where it lies on the show's texture, and how much of the paint counts there.
SkinPainter::SkinPainter(const Heads& heads, const HeadShape& head, const std::vector<Spot>& spots,
                         const face::Cast& show)
    : heads_(heads), show_(show), inside_(InsideOfMouth(head)), lids_(head) {
  for (const Spot& spot : spots) {
    uv_.push_back(spot.Of(show.topology.texture));
    shown_.push_back(ShownAt(spot.Of(show.faces.front().positions)));
    if (shown_.back() > 0.02F && shown_.back() < 0.4F) at_edge_.push_back(uv_.back());
  }
  SettleUvs(heads, head, spots, show, uv_);
}

// The ground goes on first, in the colour that the show's paint has where it fades. A triangle that would be
// copied from across a seam of the show's texture keeps the ground.
face::Texture SkinPainter::Paint(std::size_t like) const {
  const face::Texture& source = show_.textures[static_cast<std::size_t>(show_.faces[like].surface.texture)];
  std::vector<Colour> at_edge;
  for (const glm::vec2& uv : at_edge_) at_edge.push_back(At(source, uv));
  const Colour ground = GroundOf(at_edge);
  Painting painting(ground);
  for (const Triangle& t : heads_.triangles) {
    if (heads_.part[t[0]] != PartOf::kSkin) continue;
    const auto from = Corners(t, [&](Index v) { return uv_[v]; });
    if (AreApart(from)) continue;
    painting.Copy(Corners(t, [&](Index v) { return heads_.uv[v]; }), from,
                  {shown_[t[0]], shown_[t[1]], shown_[t[2]]}, source);
  }
  PaintLids(heads_, lids_, ground, painting);
  PaintInsideOfMouth(heads_, inside_, painting);
  FillMouth(heads_, painting);
  return painting.Release();
}

}  // namespace kaori::import
