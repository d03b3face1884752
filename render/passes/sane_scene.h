// A scene that can be drawn, whatever came in: numbers that are none, or far out, are brought back.
#pragma once

#include "render/scene/scene.h"

namespace kaori::passes {

// Values that are not finite become those of a fresh Scene, the rest is kept within what the stage can show;
// styles are brought to the sum 1, and with none left the default look is shown. Weights are left to the
// composer.
scene::Scene Sane(const scene::Scene& scene);
// The same into `into`, which is reused from frame to frame: its lists allocate only when they grow. Handles
// and captions are left to their passes.
void Sane(const scene::Scene& scene, scene::Scene& into);

}  // namespace kaori::passes
