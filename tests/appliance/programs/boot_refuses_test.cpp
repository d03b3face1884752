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
std::string AmongOwnMounts(const std::string& command, const std::string& besides = "") {
  const std::string user = ::geteuid() == 0 ? "" : "--user --map-root-user ";
  return "unshare " + user + besides + "--mount sh -c '" + command + "'";
}

// As process 1 among processes, mounts and devices of its own. In systemd's place stands ls(1), which gets the
// program's arguments.
Ran RunAsFirstProcess(const std::string& arguments) {
  return RunProgram(
      AmongOwnMounts("mount -t tmpfs none /dev && touch /dev/kmsg && "
                     "mount -t tmpfs none /usr/lib/systemd && "
                     "cp /bin/ls /usr/lib/systemd/systemd && exec " KAORI_BOOT " " +
                         arguments,
                     "--pid --fork "));
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

TEST(BootProgram, AppliesTheSettingsAndLeavesSystemdNoDescriptorOfItsOwn) {
  if (RunProgram(AmongOwnMounts("test -d /usr/lib/systemd && mount -t tmpfs none /dev", "--pid --fork "))
          .status != 0)
    GTEST_SKIP() << "no machine of its own can be made here, or it has no folder for systemd";
  // The test itself may have been started with some.
  const Ran inherited = RunProgram(AmongOwnMounts("ls /proc/self/fd", "--pid --fork "));
  const Ran ran = RunAsFirstProcess("/proc/self/fd /run/kaori-profile");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.said, "/proc/self/fd:\n" + inherited.said +
                          "\n/run/"
                          "kaori-profile:\nclock\ndials\nfaults\nlines\nmonitor_screen\nroot_"
                          "hash\nslot\nstage\nstatus_screen\n");
}

}  // namespace
}  // namespace kaori::boot
