// Texts as TOML files have them.
#pragma once

#include <string>
#include <string_view>

namespace kaori::toml {

// A basic string of TOML, in its quotes, that reads back as the same text: quotes, backslashes and control
// characters are escaped (TOML 1.0, section String). `text` is UTF-8. Pure.
std::string Quoted(std::string_view text);

}  // namespace kaori::toml
