// The trial of a show in another process: what it says, when it is ended, and that it has no rights.
#include <gmock/gmock.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "appliance/programs/shows/trial.h"

namespace kaori::shows {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A shell that closes its standard error, and stays.
TEST(Trial, OfAProgramThatSaysNoMoreAndDoesNotEndIsCutOff) {
  std::string name = (fs::temp_directory_path() / "kaori-silent-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  std::ofstream(folder / "stays") << "#!/bin/sh\nexec 2>&-\nexec sleep 3600\n";
  fs::permissions(folder / "stays", fs::perms::owner_all);
  const auto tried = TryPack(folder / "stays", "x", {.longest = 1s});
  ASSERT_FALSE(tried);
  EXPECT_EQ(tried.error().cause, std::errc::timed_out);
  fs::remove_all(folder);
}

// It is stopped for longer than it may take, from its first question on.
TEST(Trial, IsStoppedWhileTheFaceNeedsWhatItTakes) {
  constexpr int kQuestions = 15;  // A tenth of a second apart.
  std::string name = (fs::temp_directory_path() / "kaori-stopped-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data()), done = folder / "done";
  std::ofstream(folder / "works") << "#!/bin/sh\nsleep 0.3; echo >\"$2\"\n";
  fs::permissions(folder / "works", fs::perms::owner_all);
  int asked = 0;
  const auto may_work = [&] {
    if (++asked == kQuestions) {
      EXPECT_FALSE(fs::exists(done)) << "it went on while it was stopped";
    }
    return asked > kQuestions;
  };
  EXPECT_TRUE(TryPack(folder / "works", done.string(), {.longest = 1s, .may_work = may_work}));
  EXPECT_TRUE(fs::exists(done));
  fs::remove_all(folder);
}

// A shell tells the rights that it has, in place of the stage. The process that gives its own up is another
// one.
TEST(Trial, HasNoneOfTheRightsOfWhoStartsIt) {
  if (::prctl(PR_CAPBSET_READ, CAP_SYS_ADMIN) != 1 || ::prctl(PR_CAPBSET_READ, CAP_SETPCAP) != 1 ||
      ::geteuid() != 0)
    GTEST_SKIP() << "this process has no right to mount that it could keep";
  std::string name = (fs::temp_directory_path() / "kaori-rights-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  std::ofstream(folder / "mounts") << "#!/bin/sh\n[ $((0x$(sed -n 's/^CapEff:\\s*//p' "
                                      "/proc/self/status) >> 21 & 1)) = 1 ]\n";
  fs::permissions(folder / "mounts", fs::perms::owner_all);
  EXPECT_TRUE(TryPack(folder / "mounts", "x")) << "the shell finds the right where it has it";
  const auto try_without = [&] {
    const bool kept = KeepRightsToOurselves().has_value();
    std::exit(kept && !TryPack(folder / "mounts", "x") ? 0 : 1);
  };
  EXPECT_EXIT(try_without(), ::testing::ExitedWithCode(0), "");
  fs::remove_all(folder);
}

// The parent is as on a box: it may change its ids, and may not send a signal to whom it likes. Ends the
// process with 0 where the trial had no right and no group of its parent's, and one that hangs was ended.
[[noreturn]] void TryAsNobody(const fs::path& folder) {
  constexpr TrialUser kNobody{65534, 65534};
  if (!KeepRightsToOurselves()) std::exit(2);
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> rights{};
  if (::syscall(SYS_capget, &header, rights.data()) != 0) std::exit(3);
  rights[0].effective &= ~(1U << CAP_KILL);
  if (::syscall(SYS_capset, &header, rights.data()) != 0) std::exit(4);
  if (!TryPack(folder / "asks", "x", {.user = kNobody})) std::exit(5);
  const auto tried = TryPack(folder / "hangs", "x", {.longest = 100ms, .user = kNobody});
  if (tried || tried.error().cause != std::errc::timed_out) std::exit(6);
  std::exit(::getuid() == 0 && ::getgid() == 0 ? 0 : 7);
}

TEST(Trial, RunsAsAUserWhoOwnsNothingAndIsEndedAllTheSame) {
  if (::prctl(PR_CAPBSET_READ, CAP_SETUID) != 1 || ::geteuid() != 0)
    GTEST_SKIP() << "this process has no right to run a program as another user";
  std::string name = (fs::temp_directory_path() / "kaori-user-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  // No shell, which lets go of rights by itself where its real and its effective user differ.
  std::ofstream(folder / "asks") << R"(#!/usr/bin/python3 -I
import os, sys
nobody = (65534, 65534, 65534)
rights = [int(line.split()[1], 16) for line in open("/proc/self/status") if line.startswith(("CapEff", "CapPrm"))]
ours = os.getresuid() == os.getresgid() == nobody and not set(os.getgroups()) - {65534}
sys.exit(not ours or any(rights))
)";
  std::ofstream(folder / "hangs") << "#!/bin/sh\nexec sleep 3600\n";
  for (const fs::path& each : {folder, folder / "asks", folder / "hangs"})
    fs::permissions(each, fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  EXPECT_FALSE(TryPack(folder / "asks", "x")) << "it is root, and finds that";
  EXPECT_EXIT(TryAsNobody(folder), ::testing::ExitedWithCode(0), "");
  fs::remove_all(folder);
}

TEST(Trial, OfAUserWhomNobodyKnowsIsRefused) {
  EXPECT_TRUE(FindUser("root"));
  EXPECT_EQ(FindUser("kaori-nowhere").error().message(), "there is no user kaori-nowhere");
}

// Another program stands for the stage.
TEST(Trial, SaysWhatTheOtherProcessSaidLastAndEndsOneThatHangs) {
  EXPECT_TRUE(TryPack("/bin/true", "x"));
  EXPECT_THAT(TryPack("/bin/ls", "/nowhere/x").error().message(), HasSubstr("--help"));
  EXPECT_EQ(TryPack("/nowhere/stage", "x").error().cause, std::errc::no_such_file_or_directory);
  std::string name = (fs::temp_directory_path() / "kaori-trial-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  std::ofstream(folder / "hangs") << "#!/bin/sh\nexec sleep 60\n";
  std::ofstream(folder / "dies") << "#!/bin/sh\nkill -SEGV $$\n";
  for (const char* each : {"hangs", "dies"}) fs::permissions(folder / each, fs::perms::owner_all);
  EXPECT_EQ(TryPack(folder / "hangs", "x", {.longest = 100ms}).error().cause, std::errc::timed_out);
  int asked = 0;
  EXPECT_EQ(TryPack(folder / "hangs", "x", {.wanted = [&] { return ++asked < 2; }}).error().cause,
            std::errc::operation_canceled);
  EXPECT_THAT(TryPack(folder / "dies", "x").error().message(), HasSubstr("signal 11"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace kaori::shows
