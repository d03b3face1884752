// Which options of which programs are tried with what is no file, and which are not, each with its reason.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace kaori::test {

// One option of one program. In `words` "@" stands for the file, "%" for a folder of the test's own, "#" for the show.
struct FileOption {
  std::string name, program;
  std::vector<std::string> words;
  // What this option can bear: then the program plays on.
  std::vector<std::string> bears{};
  std::string file = "file";  // Its name in the folder.
  // What is no fault of this option: the program ends, with whatever it says of the rest.
  std::vector<std::string> passes{};
  friend void PrintTo(const FileOption& option, std::ostream* out) { *out << option.name; }
};

// All rows; each is tried with everything of Offers().
std::vector<FileOption> FileOptions();

// Whether an option of a help text that names a file needs no row: files_not_offered.cpp has the reasons.
bool NeedsNoRow(const std::string& program, const std::string& option);

// Whether a program has no option at all that names a file.
bool NamesNoFile(const std::string& program);

}  // namespace kaori::test
