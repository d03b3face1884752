// kaori-boot, where somebody starts it by hand on a machine that runs already.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <string>

namespace kaori::boot {
namespace {

using ::testing::HasSubstr;

struct Ran {
  int status = -1;
  std::string said;
};

Ran RunProgram(const std::string& command) {
  Ran ran;
  FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return ran;
  std::array<char, 4096> piece{};
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), pipe))
    ran.said.append(piece.data(), got);
  ran.status = WEXITSTATUS(::pclose(pipe));
  return ran;
}

// As root among mounts of our own, so that a program which does mount harms nobody.
std::string AmongOwnMounts(const std::string& command) {
  const std::string user = ::geteuid() == 0 ? "" : "--user --map-root-user ";
  return "unshare " + user + "--mount sh -c '" + command + "'";
}

TEST(BootProgram, DoesNothingUnlessItIsTheFirstProcess) {
  if (RunProgram(AmongOwnMounts("true")).status != 0) GTEST_SKIP() << "no mount namespace can be made here";
  for (const std::string option : {"", " --help", " quiet"}) {
    const Ran ran = RunProgram(
        AmongOwnMounts("before=$(cat /proc/self/mounts); " KAORI_BOOT + option +
                       " >/dev/null; [ \"$before\" = \"$(cat /proc/self/mounts)\" ] && echo the same"));
    EXPECT_THAT(ran.said, HasSubstr("the same")) << option;
  }
}

TEST(BootProgram, SaysWhyItDoesNothing) {
  if (RunProgram(AmongOwnMounts("true")).status != 0) GTEST_SKIP() << "no mount namespace can be made here";
  const Ran ran = RunProgram(AmongOwnMounts(KAORI_BOOT));
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.said, "kaori-boot: this is the first program of a box; it runs as process 1 only\n");
}

TEST(BootProgram, HasAPageOfHelp) {
  if (RunProgram(AmongOwnMounts("true")).status != 0) GTEST_SKIP() << "no mount namespace can be made here";
  const Ran ran = RunProgram(AmongOwnMounts(KAORI_BOOT " --help"));
  EXPECT_EQ(ran.status, 0);
  EXPECT_THAT(ran.said, HasSubstr("does nothing unless it is process 1"));
}

}  // namespace
}  // namespace kaori::boot
