#include "tests/appliance/authoring/sculpt_fixture.h"

#include <unistd.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "appliance/authoring/sculpt/sculpt.h"

namespace kaori::tests {

std::filesystem::path DefaultShowFolder() {
  return KAORI_DEFAULT_SHOW;
}

const face::Cast& SculptedCast() {
  static const face::Cast cast = [] {
    face::Cast made;
    const Result<void> done = sculpt::Sculpt(DefaultShowFolder(), made);
    if (!done) {
      std::fprintf(stderr, "%s\n", done.error().message().c_str());
      std::abort();
    }
    return made;
  }();
  return cast;
}

ShowCopy::ShowCopy() {
  std::string name = (std::filesystem::temp_directory_path() / "kaori-show-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) std::abort();
  folder_ = name;
  std::filesystem::copy(DefaultShowFolder() / "faces", folder_ / "faces");
  std::filesystem::copy(DefaultShowFolder() / "expressions.toml", folder_);
}

ShowCopy::~ShowCopy() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void ShowCopy::Replace(const std::string& file, const std::string& old_text, const std::string& new_text) {
  std::ostringstream text;
  text << std::ifstream(folder_ / file).rdbuf();
  std::string changed = text.str();
  const std::size_t at = changed.find(old_text);
  ASSERT_NE(at, std::string::npos) << file << " does not hold " << old_text;
  changed.replace(at, old_text.size(), new_text);
  std::ofstream(folder_ / file) << changed;
}

std::string ShowCopy::Complaint() const {
  face::Cast cast;
  const Result<void> done = sculpt::Sculpt(folder_, cast);
  return done ? std::string() : done.error().message();
}

}  // namespace kaori::tests
