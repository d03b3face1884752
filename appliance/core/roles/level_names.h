// The names of levels in roles.toml: those that every show has, and faces and expressions of this one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/show/roles.h"
#include "appliance/core/show/show.h"
#include "appliance/core/toml/section.h"
#include "render/face/cast.h"

namespace kaori::roles {

// The faces and expressions of a show by their indices, for levels that are of one of them, and what else
// buttons may call by its name: empty where only levels are read.
struct Items {
  std::vector<std::string> faces, expressions;
  std::vector<std::string> motions{}, scenes{}, cues{};  // Of cues the numbers.
  bool all_known = true;  // False: a file of the cast could not be read, and no name is said to be missing.
};
Items ItemsOf(const face::Cast& cast);
// With all that buttons may call.
Items ItemsOf(const show::Show& show);

// What the levels of one file are called, and which faces and expressions they are of. `mixes` are those of
// the roles below an overlay, and grow by those that the file names. Borrows both.
class LevelReader {
 public:
  LevelReader(const Items& items, std::vector<show::Call>& mixes) : items_(items), mixes_(mixes) {}

  // What stands under "level"; nothing, and a fault of it, where that is no level. Where not all names are
  // known: nothing alone.
  std::optional<show::Level> Read(toml::Section& section);

 private:
  // A face or an expression that the show has.
  std::optional<show::Level> MixOf(toml::Section& section, const show::Call& item);

  const Items& items_;
  std::vector<show::Call>& mixes_;
};

// As a file has it; "nothing" for one that these roles have not.
std::string LevelName(const show::Roles& roles, show::Level level, const Items& items);

}  // namespace kaori::roles
