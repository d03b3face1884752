// Looks at every face in the poses that a show plays, and lists what an audience must not see.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::inspect {

enum class Flaw : std::uint8_t {
  kFold,             // Triangles of the skin that are turned over; how many.
  kLidGap,           // Shut lids that show the ball; square millimetres, the worse eye.
  kTeethThroughLips  // Teeth before the lips; millimetres that they stand out.
};

struct Finding {
  Flaw flaw = Flaw::kFold;
  std::string face{};
  std::string pose{};  // "laugh", "laugh with a".
  int count = 0;       // Triangles, eyes, vertices of teeth.
  float measure = 0;   // In the unit that the flaw says.
  glm::vec3 at{};      // Metres: the first fold's middle, or the worse eye's; the origin for teeth.
};

struct Inspection {
  int folds = 0;               // Triangles, over all faces and poses.
  int lid_gaps = 0;            // Eyes.
  int teeth_through_lips = 0;  // Faces in poses.
  std::vector<Finding> findings;
};

// How much is looked for.
enum class Scope {
  kAll,         // Every flaw in every pose.
  kFoldsAlone,  // Folds, in each expression, mouth shape and channel by itself: a second or two for ten faces.
};

// Composes the fine mesh of each face in each pose (poses.h), a millisecond or two each, on all processors.
// Calls `face_begun` with each face's name, from one thread at a time. FindFaults (render/face/check.h) finds
// nothing in the cast.
Inspection Inspect(const face::Cast& cast, const std::function<void(const std::string&)>& face_begun,
                   Scope scope = Scope::kAll);

// "dog, laugh: 3 folded triangles, the first at 12 -30 95 mm".
std::string Say(const Finding& finding);

}  // namespace kaori::inspect
