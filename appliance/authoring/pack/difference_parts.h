// The parts of Differences: one item before and after, and a line for what changed in it.
#pragma once

#include <string>
#include <vector>

#include "appliance/core/show/show.h"

namespace kaori::authoring {

// Each function appends a line for each thing that differs, and none where nothing does. `item` begins the
// lines: "face "dog"".
using Lines = std::vector<std::string>;

// An expression, and the net whose points it moves, by which displacements are matched; borrowed.
struct WornExpression {
  const face::ControlNet& net;
  const face::Expression& expression;
};

// A scene, and the show whose faces and expressions it numbers; borrowed.
struct ScriptedScene {
  const show::Show& show;
  const show::StageScene& scene;
};

// Counts first: where those differ, nothing else of two meshes can be compared.
void CompareTopology(const face::Topology& a, const face::Topology& b, Lines& lines);
// Positions, eyes, mouth fit, look, shade and gain; not its props, which are compared by name.
void CompareFace(const std::string& item, const face::Face& a, const face::Face& b, Lines& lines);
// Null where a face has none.
void CompareTexture(const std::string& item, const face::Texture* a, const face::Texture* b, Lines& lines);
// Vertices and shade where the triangles are the same, else that they differ.
void CompareProp(const std::string& item, const face::Prop& a, const face::Prop& b, Lines& lines);
// How far it lies elsewhere in the parameter space.
void ComparePoint(const std::string& item, const face::ControlPoint& a, const face::ControlPoint& b,
                  Lines& lines);
// The largest difference of a displacement in millimetres, and its point; a point that one of the two
// lacks rests there.
void CompareExpression(const std::string& item, const WornExpression& a, const WornExpression& b,
                       Lines& lines);
// Whether key, curves or sound differ.
void CompareMotion(const std::string& item, const show::Motion& a, const show::Motion& b, Lines& lines);
// By names of faces and expressions, so that renumbering is no difference.
void CompareScene(const std::string& item, const ScriptedScene& a, const ScriptedScene& b, Lines& lines);
// Buttons, keys and channels, by what they call: an item that only has another number plays alike.
void CompareControls(const show::Show& a, const show::Show& b, Lines& lines);
// Each cue by its number, and what holds for all of them, by the names that cues.toml has for them.
void CompareCues(const show::Show& a, const show::Show& b, Lines& lines);
// Cue, visitor, times, greetings and hours of the lobby, by the names that lobby.toml has for them.
void CompareLobby(const show::Show& a, const show::Show& b, Lines& lines);

}  // namespace kaori::authoring
