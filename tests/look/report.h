// What the tests of the look measured, for programs that judge it: out/look.json.
#pragma once

#include <string_view>

namespace kaori::tests {

// Sets `key` in the report, beside what other tests wrote. Tests of several processes may report at once. A failure to
// write fails the test.
void Report(std::string_view key, double value);

}  // namespace kaori::tests
