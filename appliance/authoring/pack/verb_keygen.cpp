#include <fmt/format.h>

#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/show/pack_key.h"
#include "drivers/base/program.h"

namespace kaori::authoring {
namespace {

// The public key is written beside the secret one, by SaveKey; nothing is overwritten.
int RunKeygen(const Arguments& arguments) {
  const std::string& file = arguments.words[0];
  const auto key = show::MakeKey();
  if (!key) return ExitWithError(key.error());
  if (const auto ok = show::SaveKey(*key, file); !ok) return ExitWithError(ok.error());
  // The message names both files, since only one of them may be given away.
  fmt::print("{}: signs packs; keep it to yourself\n{}.pub: for the boxes that are to play them\n", file,
             file);
  return 0;
}

}  // namespace

Verb KeygenVerb() {
  return {.name = "keygen",
          .words = {"KEYFILE"},
          .options = {},
          .summary = "make a key that signs packs, and KEYFILE.pub for the boxes",
          .page = R"(
KEYFILE is readable by its owner alone, and no key is ever written over. Sign with `kaori-atelier pack --sign KEYFILE`;
give KEYFILE.pub to the boxes (`kaori-stage --trust KEYFILE.pub`). Ed25519.
)",
          .run = RunKeygen};
}

}  // namespace kaori::authoring
