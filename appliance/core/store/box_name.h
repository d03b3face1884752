// Which box this is, for people: its name, and beside it the beginning of its number, since a name that came by a stick may
// be that of several boxes.
#pragma once

#include <string>
#include <string_view>

namespace kaori::store {

// Where kaori-boot leaves the number, 32 hexadecimal digits (machine-id(5)); on a computer that is no box it is missing.
inline constexpr const char* kBoxNumberFile = "/run/kaori-profile/machine-id";
// As many digits as the name has of a box that was given none, and as the names of its files have.
inline constexpr std::size_t kShownDigits = 8;

// "left-lobby (1a2b3c4d)". The name alone where it ends with those digits, as "kaori-1a2b3c4d" does, and where one of the two
// is empty. Pure.
inline std::string NameWithNumber(std::string_view name, std::string_view number) {
  const auto shown = number.substr(0, kShownDigits);
  std::string whole(name);
  if (!name.empty() && !shown.empty() && !name.ends_with(shown)) whole += " (" + std::string(shown) + ")";
  return whole;
}

}  // namespace kaori::store
