// A copy of the default show's folder, for tests that spoil it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {

class CheckedFolder : public PackTest {
 protected:
  CheckedFolder() {
    std::filesystem::copy(KAORI_DEFAULT_SHOW, show_, std::filesystem::copy_options::recursive);
  }

  std::string TextOf(const char* file) const {
    std::ifstream in(show_ / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  void Replace(const char* file, const std::string& what, const std::string& with) const {
    std::string text = TextOf(file);
    const auto at = text.find(what);
    ASSERT_NE(at, std::string::npos) << file << " no longer holds " << what;
    text.replace(at, what.size(), with);
    std::ofstream(show_ / file) << text;
  }

  void Append(const char* file, const std::string& text) const {
    std::ofstream(show_ / file, std::ios::app) << text;
  }

  // For tests/appliance/show_report.py: this test has a faulty file, and what is wrong with it was named or not.
  static void CountNamed(bool named) {
    RecordProperty("faulty_files", 1);
    RecordProperty("faulty_files_named", named ? 1 : 0);
  }

  const std::filesystem::path show_ = folder_ / "show";
};

}  // namespace kaori::tests
