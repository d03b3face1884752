// Contact sheets: every face with every expression, every style, every way of looking, to be looked at.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "appliance/stage/studio.h"
#include "drivers/base/result.h"

namespace kaori::atelier {

struct SheetOptions {
  int cell_width_px = 320;
  int cell_height_px = 360;
};

// Writes PNG files into `folder` (made if need be) and says each name through `wrote`:
//   faces.png        each face from five sides
//   styles.png       each face in the five styles
//   face-NAME.png    one face with every expression, mouth shape and channel
//   morphs.png       from the first face to each other one in five steps
//   index.html       the same with names, for a browser
// Errors: those of the file system and of drawing.
Result<void> DrawSheets(stage::Studio& studio, const std::filesystem::path& folder,
                        const SheetOptions& options, const std::function<void(std::string_view)>& wrote);

}  // namespace kaori::atelier
