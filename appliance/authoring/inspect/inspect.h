// Looks at every face in the poses that a show plays, and lists what an audience must not see.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::inspect {

// What is counted, and in which unit Finding::measure says how much.
enum class Flaw : std::uint8_t {
  // Triangles of the skin that are turned over; how many.
  kFold,
  // Shut lids that show the ball; square millimetres, the worse eye.
  kLidGap,
  // Teeth before the lips; millimetres that they stand out.
  kTeethThroughLips
};

// One flaw of one face in one pose.
struct Finding {
  Flaw flaw = Flaw::kFold;
  std::string face{};
  // As Pose::name: "laugh", "laugh with a".
  std::string pose{};
  // Triangles, eyes, or vertices of teeth, by the flaw.
  int count = 0;
  float measure = 0;  // In the unit that the flaw says.
  // Metres: the first fold's middle, or the centre of the worse eye; the origin for teeth.
  glm::vec3 at{};
};

// Sums, and all findings in the order of faces and poses.
struct Inspection {
  // Triangles, over all faces and poses; a triangle counts in each pose anew, but one that is folded at rest once.
  int folds = 0;
  int lid_gaps = 0;            // Eyes.
  int teeth_through_lips = 0;  // Faces in poses.
  std::vector<Finding> findings;
};

// How much is looked for.
enum class Scope {
  kAll,  // Every flaw in every pose.
  // Folds alone, in each expression, mouth shape and channel by itself: a second or two for ten faces.
  kFoldsAlone,
};

// Composes the fine mesh of each face in each pose (poses.h), a millisecond or two each, on all processors:
// a face is one thread's. Blocks until all is done; the result does not depend on the threads. Calls
// `face_begun` with each face's name, from one thread at a time, though not the caller's. `cast` is
// borrowed and must stand still; FindFaults (render/face/check.h) finds nothing in it. A cast without a
// fine mesh has no findings.
Inspection Inspect(const face::Cast& cast, const std::function<void(const std::string&)>& face_begun,
                   Scope scope = Scope::kAll);

// For people: "dog, laugh: 3 folded triangles, the first at 12 -30 95 mm".
std::string Say(const Finding& finding);

}  // namespace kaori::inspect
