#include "appliance/authoring/script/backdrop_file.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/authoring/script/colour_text.h"
#include "render/image/png.h"

namespace kaori::authoring {
namespace {

// In the order of scene::BackdropKind.
constexpr std::array<const char*, scene::kBackdropKindCount> kKinds{
    "gradient", "studio", "curtain", "night", "kitchen", "pine", "lights", "rays", "nursery", "picture"};
constexpr std::array<std::string_view, 5> kWords{"kind", "top", "bottom", "glow", "picture"};

// Wider ones would only be made smaller: backdrops are shown out of focus.
constexpr int kWidestPicture_px = 4096;

// Pictures hold the bottom row first, textures the top row.
face::Texture TextureOf(const image::Picture& picture) {
  face::Texture texture{picture.width_px, picture.height_px, {}};
  const std::size_t row_bytes = static_cast<std::size_t>(picture.width_px) * 4;
  texture.rgba.own().resize(picture.rgbx.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height_px); ++y) {
    const std::size_t from = (static_cast<std::size_t>(picture.height_px) - 1 - y) * row_bytes;
    std::copy_n(picture.rgbx.begin() + static_cast<std::ptrdiff_t>(from), row_bytes,
                texture.rgba.own().begin() + static_cast<std::ptrdiff_t>(y * row_bytes));
  }
  return texture;
}

class Reader {
 public:
  Reader(const toml::table& table, std::vector<face::Texture>& textures)
      : table_(table), textures_(textures) {}

  BackdropReading Read(const std::filesystem::path& folder) {
    CheckWords();
    if (table_.contains("picture"))
      ReadPicture(folder);
    else
      ReadKind();
    const bool picture = reading_.backdrop.kind == scene::BackdropKind::kPicture;
    ReadColour("top", !picture, reading_.backdrop.top);
    ReadColour("bottom", !picture, reading_.backdrop.bottom);
    ReadColour("glow", false, reading_.backdrop.glow);
    return std::move(reading_);
  }

 private:
  template <class... Values>
  void Fault(fmt::format_string<Values...> reason, Values&&... values) {
    reading_.faults.push_back("its backdrop: " + fmt::format(reason, std::forward<Values>(values)...));
  }

  void CheckWords() {
    for (const auto& [key, node] : table_)
      if (std::ranges::find(kWords, key.str()) == kWords.end())
        Fault("line {}: nothing is called \"{}\" here; words are {}", key.source().begin.line, key.str(),
              fmt::join(kWords, ", "));
  }

  void ReadKind() {
    const auto name = table_["kind"].value_or(std::string(kKinds[0]));
    const auto known = std::ranges::find(kKinds, name);
    if (known == kKinds.end())
      return Fault("there is no kind \"{}\"; kinds are {}", name, fmt::join(kKinds, ", "));
    reading_.backdrop.kind = static_cast<scene::BackdropKind>(known - kKinds.begin());
    if (reading_.backdrop.kind == scene::BackdropKind::kPicture)
      Fault("a picture is named by picture = \"file.png\"");
  }

  void ReadColour(std::string_view word, bool wanted, glm::vec3& colour) {
    if (!wanted && !table_.contains(word)) return;
    const auto text = table_[word].value_or(std::string());
    if (const auto read = ColourOf(text))
      colour = *read;
    else
      Fault("{} = \"{}\" is no colour; write one as \"#41506a\"", word, text);
  }

  void ReadPicture(const std::filesystem::path& folder) {
    reading_.backdrop.kind = scene::BackdropKind::kPicture;
    const auto name = table_["picture"].value_or(std::string());
    const auto picture = image::ReadPng(folder / name);
    if (!picture) return Fault("{}", picture.error().message());
    if (std::max(picture->width_px, picture->height_px) > kWidestPicture_px)
      return Fault("{} has {} x {} pixels, and {} a side are the most", name, picture->width_px,
                   picture->height_px, kWidestPicture_px);
    reading_.backdrop.picture = static_cast<int>(textures_.size());
    textures_.push_back(TextureOf(*picture));
  }

  const toml::table& table_;
  std::vector<face::Texture>& textures_;
  BackdropReading reading_;
};

}  // namespace

BackdropReading ReadBackdrop(const toml::node* backdrop, const std::filesystem::path& folder,
                             std::vector<face::Texture>& textures) {
  const auto* table = backdrop == nullptr ? nullptr : backdrop->as_table();
  if (table == nullptr)
    return {{}, {"it wants a backdrop, such as { top = \"#41506a\", bottom = \"#1b2030\" }"}};
  return Reader(*table, textures).Read(folder);
}

const char* NameOf(scene::BackdropKind kind) {
  return static_cast<std::size_t>(kind) < kKinds.size() ? kKinds[static_cast<std::size_t>(kind)] : "nothing";
}

}  // namespace kaori::authoring
