#include <fmt/format.h>

#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// Both paths of SignPack are the same: it replaces the file in one step.
int RunSign(const Arguments& arguments) {
  const std::string &file = arguments.words[0], &key_file = arguments.words[1];
  const auto key = show::ReadSecretKey(key_file);
  if (!key) return ExitWithError(key.error());
  if (const auto ok = show::SignPack(file, file, *key); !ok) return ExitWithError(ok.error());
  // The fingerprint is short enough to be compared by people, as the whole key is not.
  fmt::print("{}: signed; boxes that have the key {} play it\n", file, show::Fingerprint(key->public_key()));
  return 0;
}

}  // namespace

Verb SignVerb() {
  return {.name = "sign",
          .words = {"PACK", "KEYFILE"},
          .options = {},
          .summary = "sign a pack that is there",
          .page = R"(
PACK is checked as a whole and signed with the key that `kaori-atelier keygen` wrote; a signature that it had before is
replaced. It is written in one step, and kept as it is where anything fails.
)",
          .run = RunSign};
}

}  // namespace kaori::authoring
