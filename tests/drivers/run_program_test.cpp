// Programs that are run to their end.
#include <gtest/gtest.h>

#include "drivers/base/run_program.h"

namespace kaori {
namespace {

TEST(RunProgram, ThatAreMissingOrEndBySignalAreSeen) {
  EXPECT_FALSE(RunProgram({"/sbin/no-such-program"}));
  EXPECT_EQ(RunProgram({"/bin/sh", "-c", "exit 3"}), 3);
  EXPECT_EQ(RunProgram({"/bin/sh", "-c", "kill -9 $$"}), 128 + 9);
}

}  // namespace
}  // namespace kaori
