// Puts every kept input of one fuzz target through its function.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace kaori::fuzz {
namespace {

TEST(Corpus, IsTakenWithoutHarm) {
  int inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(KAORI_CORPUS)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    EXPECT_EQ(LLVMFuzzerTestOneInput(bytes.data(), bytes.size()), 0) << entry.path();
    ++inputs;
  }
  EXPECT_GT(inputs, 0) << "no inputs are kept in " << KAORI_CORPUS;
}

}  // namespace
}  // namespace kaori::fuzz
