// What a fuzz target holds to be true: a broken promise stops the program, so that the fuzzer keeps the
// input.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace kaori::fuzz {

inline void Promise(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

}  // namespace kaori::fuzz
