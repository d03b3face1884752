// Runs the tests that need made-up kernel devices within umockdev, which has to be loaded before everything.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

constexpr const char* kPreload = "libumockdev-preload.so.0";
// We have already run ourselves again; or need not, where nothing of the fake kernel's is tested (rootfs/toolchains/cross.sh).
constexpr const char* kMarker = "KAORI_IN_MOCK_KERNEL";

std::string Preloads() {
  const char* others = std::getenv("LD_PRELOAD");
  return others == nullptr ? kPreload : std::string(kPreload) + ":" + others;
}

}  // namespace

int main(int argc, char** argv) {
  if (std::getenv(kMarker) == nullptr) {
    ::setenv(kMarker, "1", 1);
    ::setenv("LD_PRELOAD", Preloads().c_str(), 1);
    ::setenv("ASAN_OPTIONS", "verify_asan_link_order=0:detect_leaks=0", 1);  // glib and umockdev keep memory.
    ::execv("/proc/self/exe", argv);
    std::perror("run again within umockdev");
    return 1;
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
