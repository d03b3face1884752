// The page of the contact sheets as it stands in page.html, carried in the program.
#pragma once

#include <string_view>

namespace kaori::authoring {

extern const std::string_view kPage;  // "@DATA@" stands for the sheets' description, JSON.

}  // namespace kaori::authoring
