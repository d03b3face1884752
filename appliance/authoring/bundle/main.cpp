// kaori-bundle: makes an update of a box, of an image that was built and tested, and signs it.
#include <string>

#include <fmt/format.h>

#include "appliance/authoring/bundle/bundle_maker.h"
#include "drivers/base/number.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"

namespace {

constexpr std::string_view kHelp = R"(kaori-bundle: makes an update of a box

  --image FOLDER  as rootfs/image/build made it
  --key FILE      the secret key that signs; boxes trust the public ones that their image was built with
  --from N        the lowest version from which a box may come to this one (1)
  --news TEXT     what is new, one line; of Japanese 32 letters at most, of others 96
  --smallest      packs it as small as it can, which takes minutes
  --to FILE       what is made, as in kaori-12.kaoriupdate
)";

struct Settings {
  std::string image, key, news, to, from = "1";
  bool smallest = false;
};

}  // namespace

// Errors are one line; nothing is there then.
int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-bundle");
  Settings settings;
  kaori::Options options(kHelp);
  options.Switch("--smallest", settings.smallest)
      .Text("--image", settings.image)
      .Text("--key", settings.key)
      .Text("--from", settings.from)
      .Text("--news", settings.news)
      .Text("--to", settings.to);
  if (const auto status = options.Parse(argc, argv)) return *status;
  const auto key = kaori::show::ReadSecretKey(settings.key);
  if (!key) return kaori::ExitWithError(key.error());
  const auto version = kaori::authoring::VersionOf(settings.image);
  if (!version) return kaori::ExitWithError(version.error());
  const auto from = kaori::ParseNumber<std::uint32_t>(settings.from);
  if (!from)
    return kaori::ExitWithError(kaori::FailInput("--from " + settings.from + ": expected a number").value());
  const auto product = kaori::authoring::ProductOf(settings.image);
  if (!product) return kaori::ExitWithError(product.error());
  const kaori::update::Manifest manifest{
      .version = *version, .from = *from, .product = *product, .news = settings.news};
  const auto packing = settings.smallest ? kaori::update::Packing::kSmallest : kaori::update::Packing::kQuick;
  const auto made = kaori::authoring::MakeBundle(manifest, kaori::authoring::PartFiles(settings.image), *key,
                                                 settings.to, packing);
  if (!made) return kaori::ExitWithError(made.error());
  fmt::print("{}: version {}, signed by {}\n", settings.to, *version,
             kaori::show::Fingerprint(key->public_key()));
  return 0;
}
