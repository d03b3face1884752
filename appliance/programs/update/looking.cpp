#include "appliance/programs/update/looking.h"

#include <algorithm>
#include <string>

#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::update {
namespace {

// Further ones are as many.
constexpr int kMostLooks = 9;

void Note(const std::filesystem::path& file, int looks) {
  if (auto noted = WriteWholeFile(file, {AsBytes(std::to_string(looks))}); !noted)
    LogWarning("{}", noted.error().message());
}

}  // namespace

Reason VainLook() {
  return {"what looks at a new version hung, or ended before it had seen enough",
          "新しい版を確かめるプログラムが止まったか、途中で終わりました"};
}

void BeginLook(const std::filesystem::path& file) {
  Note(file, 1);
}

void EndLook(const std::filesystem::path& file) {
  std::error_code none;
  std::filesystem::remove(file, none);
}

// A file that is there and says nothing is of one look at least.
int LooksInVain(const std::filesystem::path& file) {
  const auto text = ReadFile(file);
  if (!text) return 0;
  const int looks = std::clamp(ParseNumber<int>(*text).value_or(1), 1, kMostLooks);
  Note(file, std::min(looks + 1, kMostLooks));
  return looks;
}

}  // namespace kaori::update
