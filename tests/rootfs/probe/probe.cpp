// Compiles only with the flags of the SDK's environment.
#include <alsa/version.h>

static_assert(KAORI_FLAG_OF_THE_SDK == 7 && KAORI_FLAG_OF_THE_COMPILER == 8);

int main() {
  return 0;
}
