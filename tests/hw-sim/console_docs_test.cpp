// What docs/scenarios.md tells people to write can be read.
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hw-sim/scenario/reader.h"

namespace kaori::console {
namespace {

constexpr std::string_view kIndent = "    ";

std::vector<std::string> Lines() {
  std::ifstream file(std::string(KAORI_DOCS) + "/scenarios.md");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

bool IsOfAShell(const std::string& line) {
  return line.starts_with("    ./box") || line.starts_with("    my.play:");
}

// What stands between back quotes in the first column of a table's row.
std::vector<std::string> Statements(const std::string& line) {
  std::vector<std::string> statements;
  if (!line.starts_with("| `")) return statements;
  const std::string column = line.substr(0, line.find(" |", 2));
  for (auto open = column.find('`'); open != std::string::npos;) {
    const auto end = column.find('`', open + 1);
    statements.push_back(column.substr(open + 1, end - open - 1));
    open = column.find('`', end + 1);
  }
  return statements;
}

std::string Faults(const std::string& text) {
  return sim::Describe(sim::ReadScenario(text).problems, "scenarios.md");
}

TEST(ScenarioDocs, HaveExamplesThatCanBePlayed) {
  int examples = 0;
  std::string example;
  for (const std::string& line : Lines()) {
    if (line.starts_with(kIndent) && !IsOfAShell(line)) {
      example += line.substr(kIndent.size()) + '\n';
      continue;
    }
    if (example.empty()) continue;
    ++examples;
    EXPECT_EQ(Faults(example), "") << example;
    example.clear();
  }
  EXPECT_GE(examples, 4);
}

TEST(ScenarioDocs, HaveTablesOfWhatAnOperatorCanDo) {
  int statements = 0;
  for (const std::string& line : Lines())
    for (const std::string& statement : Statements(line)) {
      ++statements;
      EXPECT_EQ(Faults("at 1s " + statement), "") << statement;
    }
  EXPECT_GE(statements, 20);
}

}  // namespace
}  // namespace kaori::console
