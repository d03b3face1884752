#include "tests/render/default_cast.h"

#include <optional>
#include <string>

#include "appliance/show/pack.h"

namespace kaori::testing {
namespace {

struct Loaded {
  std::optional<show::Show> show;
  std::string why;
};

Loaded Load() {
  auto show = show::LoadPack(KAORI_DEFAULT_PACK);
  if (!show) return {std::nullopt, show.error().message()};
  return {std::move(*show), ""};
}

}  // namespace

const face::Cast* DefaultCast(const char** why) {
  static const Loaded loaded = Load();
  if (why != nullptr) *why = loaded.why.c_str();
  return loaded.show ? &loaded.show->cast : nullptr;
}

}  // namespace kaori::testing
