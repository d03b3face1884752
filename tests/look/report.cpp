#include "tests/look/report.h"

#include <fcntl.h>
#include <sys/file.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "drivers/base/unique_fd.h"

namespace kaori::tests {

void Report(std::string_view key, double value) {
  const std::filesystem::path file = KAORI_LOOK_REPORT;
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  // The lock is on a file of its own, since the report is replaced.
  const UniqueFd lock(::open((file.string() + ".lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644));
  ASSERT_GE(lock.get(), 0) << file;
  ASSERT_EQ(::flock(lock.get(), LOCK_EX), 0);
  std::ifstream in(file);
  auto report = nlohmann::json::parse(in, nullptr, false);
  if (!report.is_object()) report = nlohmann::json::object();
  report[std::string(key)] = value;
  const std::string part = file.string() + ".part";
  std::ofstream(part) << report.dump(1) << '\n';
  std::filesystem::rename(part, file, ignored);
  EXPECT_FALSE(ignored) << file << ": " << ignored.message();
}

}  // namespace kaori::tests
