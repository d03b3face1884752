// What kaori-shows says to the screen: a file in memory (/run/kaori-shows/lines), one sentence a line, in English and
// in Japanese, which kaori-status and the stage's status picture show while the service key is on.
#pragma once

#include <string_view>

namespace kaori::store {

// Stands before a line that says that nothing was installed and why; it is not shown, the line gets a fault's mark.
inline constexpr std::string_view kRefusalMark = "! ";

}  // namespace kaori::store
