// Puts every kept input of one fuzz target through its function: test-fuzz-NAME FOLDER. A target that finds a fault ends
// the program. It is a program without GoogleTest, whose headers cost more to compile than a target.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "expected the folder of the kept inputs\n");
    return 2;
  }
  int inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) {
    std::fprintf(stderr, "%s\n", entry.path().c_str());
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    if (LLVMFuzzerTestOneInput(bytes.data(), bytes.size()) != 0) {
      std::fprintf(stderr, "the target refused this input\n");
      return 1;
    }
    ++inputs;
  }
  if (inputs == 0) std::fprintf(stderr, "no inputs are kept in %s\n", arguments[1]);
  return inputs == 0;
}
