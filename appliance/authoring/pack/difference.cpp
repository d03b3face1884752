#include "appliance/authoring/pack/difference.h"

#include <algorithm>

#include <fmt/format.h>

#include "appliance/authoring/pack/difference_parts.h"

namespace kaori::authoring {
namespace {

// Pairs items by name; says which are new and which are gone, and compares the others. In the order of
// `before`, new ones last. O(n^2): there are some hundred at most.
template <class Items, class Compare>
void CompareByName(const char* kind, const Items& before, const Items& after, Lines& lines, Compare compare) {
  // The name is compared and not the index: indices of a pack change whenever an item is added before others.
  const auto find = [](const Items& items, const std::string& name) {
    return std::ranges::find(items, name, [](const auto& item) { return item.name; });
  };
  for (const auto& old : before) {
    const auto now = find(after, old.name);
    const std::string item = fmt::format("{} \"{}\"", kind, old.name);
    if (now == after.end())
      lines.push_back(item + ": is gone");
    else
      compare(item, old, *now);
  }
  for (const auto& now : after)
    if (find(before, now.name) == before.end())
      lines.push_back(fmt::format("{} \"{}\": is new", kind, now.name));
}

// Null where the face has none.
const face::Texture* TextureOf(const face::Cast& cast, const face::Face& face) {
  const auto index = static_cast<std::size_t>(face.surface.texture);
  return face.surface.texture >= 0 && index < cast.textures.size() ? &cast.textures[index] : nullptr;
}

// The faces' own, and what each of them wears. Props are compared once, whoever wears them.
void CompareFaces(const face::Cast& before, const face::Cast& after, Lines& lines) {
  CompareByName("face", before.faces, after.faces, lines,
                [&](const std::string& item, const face::Face& a, const face::Face& b) {
                  CompareFace(item, a, b, lines);
                  CompareTexture(item, TextureOf(before, a), TextureOf(after, b), lines);
                });
  CompareByName("prop", before.props, after.props, lines,
                [&](const std::string& item, const face::Prop& a, const face::Prop& b) {
                  CompareProp(item, a, b, lines);
                });
}

// Displacements are matched by the names of their control points.
void CompareExpressions(const face::Cast& before, const face::Cast& after, Lines& lines) {
  CompareByName("control point", before.net.points, after.net.points, lines,
                [&](const std::string& item, const face::ControlPoint& a, const face::ControlPoint& b) {
                  ComparePoint(item, a, b, lines);
                });
  CompareByName("expression", before.expressions, after.expressions, lines,
                [&](const std::string& item, const face::Expression& a, const face::Expression& b) {
                  CompareExpression(item, {before.net, a}, {after.net, b}, lines);
                });
}

}  // namespace

// From the mesh over faces and expressions to the script: as one would look for a cause.
std::vector<std::string> Differences(const show::Show& before, const show::Show& after) {
  Lines lines;
  if (before.name != after.name)
    lines.push_back(fmt::format("show: \"{}\" is now \"{}\"", before.name, after.name));
  CompareTopology(before.cast.topology, after.cast.topology, lines);
  // Faces are compared even where the topologies differ: CompareFace looks at the counts itself.
  CompareFaces(before.cast, after.cast, lines);
  CompareExpressions(before.cast, after.cast, lines);
  CompareByName("motion", before.motions, after.motions, lines,
                [&](const std::string& item, const show::Motion& a, const show::Motion& b) {
                  CompareMotion(item, a, b, lines);
                });
  CompareByName("scene", before.scenes, after.scenes, lines,
                [&](const std::string& item, const show::StageScene& a, const show::StageScene& b) {
                  CompareScene(item, {before, a}, {after, b}, lines);
                });
  // Controls, cues and lobby come last, since they call the items that the lines above have told of.
  CompareControls(before, after, lines);
  CompareCues(before, after, lines);
  CompareLobby(before, after, lines);
  return lines;
}

}  // namespace kaori::authoring
