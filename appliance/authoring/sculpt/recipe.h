// What the files of a show say about the shape of a face. Lengths in centimetres, angles in degrees, the
// frame of Cast (+x the character's left, +y up, +z out of the face); only the left half is described.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "appliance/authoring/sculpt/half_topology.h"
#include "appliance/authoring/sculpt/signed_distance.h"

namespace kaori::sculpt {

// No part of a head lies farther from the origin along any axis: room for giants and puppets. Beyond it a length was
// meant in metres or in millimetres.
inline constexpr double kFarthest_cm = 60;

// Where some vertices of the grid are aimed before they are projected: rows of points, smooth in between. It
// is written for the reference face.
struct AimTable {
  // Grid columns, rising from 0 to 26; not all of them need to be there.
  std::vector<double> columns;
  std::vector<double> rows;                     // Grid rows, rising from 0 to 36.
  std::vector<std::vector<glm::dvec3>> points;  // [row][column]
};

// The reference face's table, stretched for another face; factors of x and of y above and below the eyes'
// level (y = 0).
struct AimScale {
  double x = 1;
  double y_above_eyes = 1;
  double y_below_eyes = 1;
};

// The left eye, its lids open, seen from the front. The right one is its mirror image.
struct EyeRecipe {
  // Of the ball.
  glm::dvec3 centre{};
  double radius = 0;
  // The lids' inner and outer corner in x and y; their depth comes from the ball.
  double inner_x = 0, inner_y = 0;
  double outer_x = 0, outer_y = 0;
  // How high the open upper lid arches over the line between the corners, and how deep the lower one hangs.
  double upper_height = 0;
  double lower_height = 0;
  // How far the lid's margin stands over the ball. Below 0.13 the fine mesh, which shrinks edges a little,
  // lets the ball show through.
  double thickness = 0.13;
  // Depth of the fold in the upper lid.
  double crease = 0.16;
};

// The shut mouth at rest, seen from the front; `y` is the height of the line between the lips.
struct MouthRecipe {
  // From the middle to a corner.
  double half_width = 0;
  double y = 0;
  // Of the lips, in the middle, above and below that line.
  double upper_height = 0;
  double lower_height = 0;
  // How far the corners rise above it.
  double upturn = 0;
  // A factor of how far the lips bulge.
  double fullness = 1;
};

// Half of the height and of the width, and how far the top leans back.
struct EarRecipe {
  double height = 3.1;
  double width = 1.75;
  double tilt_deg = 14;
};

// A vertex, and where it goes.
struct Landmark {
  // On the left half or in the middle.
  Key vertex;
  glm::dvec3 target{};
};

// A solid of round bodies, onto which the grid is projected.
struct Carved {
  // Only the table of the cast is stretched; bodies are this face's own.
  AimScale scale;
  std::vector<Body> bodies;
  std::vector<Landmark>
      touches;  // Points of the grid set by hand, where a solid is too coarse: the nose's base.
  EyeRecipe eye;
  MouthRecipe mouth;
  EarRecipe ear;
};

// The ear's block drawn out into a tube: six stations from the head to the tip.
struct Tube {
  std::vector<glm::dvec3> path;
  std::vector<double> half_width;
  std::vector<double> half_thickness;
  glm::dvec3 width_direction{};
  double cap = 0;  // How far the end bulges.
  // The height of the joint from which it hangs and swings; none where it stands.
  std::optional<double> hangs_from_y{};
};

// The reference face pulled to landmarks.
struct Warped {
  // Where vertices of the reference face go; mirrored on the right.
  std::vector<Landmark> landmarks;
  glm::dvec3 eye_shift{};  // The ball goes here from its place in the reference face,
  double eye_scale = 1;    // and so do four points of the lids' margin, scaled about it.
  double eye_radius = 0;
  double lid_thickness = 0.13;
  // Of the grid, after the warp.
  int smoothing_steps = 0;
  Tube ear;
};

// The nose of a kettle, along an axis from `foot` to `tip`.
struct Spout {
  glm::dvec3 foot{};  // Start and end of its axis.
  glm::dvec3 tip{};
  // Half of the foot's width and height, where it stands on the body.
  double foot_width = 0;
  double foot_height = 0;
  double foot_out = 0;  // How far the foot stands out along the axis.
  double rim_radius = 0;
  // How far the inside lies below the rim, and how wide it is there.
  double hole_depth = 0;
  double hole_radius = 0;
};

// A turned body with a spout for a nose and a handle for ears. The profile says radius and height by grid
// row, the angles (round the axis from the front) by grid column; both are smooth in between.
struct Turned {
  // Grid rows, and radius and height of the body at each.
  std::vector<double> profile_rows;
  std::vector<double> profile_radius;
  std::vector<double> profile_y;
  // Grid columns that the angles are given for.
  std::vector<double> columns;
  std::vector<double> angles_deg;  // Round the axis from the front.
  double knob_y = 0;               // The crown's seam lies across the knob.
  double knob_radius = 0;
  double eye_yaw_deg = 0;  // Where the eyes look to.
  double lid_thickness = 0.15;
  double mouth_scale = 1;  // Of the lips; the rings around grow less.
  double lip_relief = 0;
  double wall_radius = 10.5;  // Of the wall where the mouth is.
  Spout spout;
  Tube handle;
};

// The cast's own mesh, shaped in a modelling tool (modelled.h).
struct Modelled {
  // As an open file names it: beside the face's own file.
  std::filesystem::path mesh;
  // Of both lids, as EyeRecipe::thickness: how far their margins stand over the balls that come with the mesh. Where
  // nothing is said, as far as they stand in the file.
  std::optional<double> lid_thickness{};
};

// One face's file, read. `file` is its path, for faults that are found later.
struct FaceRecipe {
  // From the list in cast.toml.
  std::string name;
  std::string file;
  // Which way of shaping it, and all that belongs to it.
  std::variant<Carved, Warped, Turned, Modelled> shape;
  // As face::MouthFit, in centimetres; of a modelled head in addition to where its own mouth lies.
  double teeth_scale = 1;
  glm::dvec3 teeth_offset{};
  double upper_teeth = 1;
  double lower_teeth = 1;
  double tongue = 1;
  // As face::Face::expression_gain.
  double expression_gain = 1;
};

// faces/cast.toml, and the faces in its order.
struct CastRecipe {
  // Of the reference face; others stretch it.
  AimTable aim;
  std::vector<FaceRecipe> faces;  // The first is the reference face, and carved.
};

}  // namespace kaori::sculpt
