#include "tests/render/default_cast.h"

#include <cstdio>
#include <cstdlib>

#include "appliance/authoring/sculpt/sculpt.h"

namespace kaori::tests {
namespace {

face::Cast SculptedCast() {
  face::Cast cast;
  const auto sculpted = sculpt::Sculpt(KAORI_DEFAULT_SHOW, cast);
  if (sculpted) return cast;
  std::fprintf(stderr, "%s\n", sculpted.error().message().c_str());
  std::abort();
}

}  // namespace

const face::Cast& DefaultCast() {
  static const face::Cast cast = SculptedCast();
  return cast;
}

}  // namespace kaori::tests
