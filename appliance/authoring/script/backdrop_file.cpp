#include "appliance/authoring/script/backdrop_file.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/authoring/script/colour_text.h"
#include "render/image/png.h"

namespace kaori::authoring {
namespace {

// The words of show.toml, in the order of scene::BackdropKind.
constexpr std::array<std::string_view, scene::kBackdropKindCount> kKinds{
    "gradient", "studio", "curtain", "night", "kitchen", "pine", "lights", "rays", "nursery", "picture"};

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

// "picture" is no word for a kind: it needs a file, and that says it.
scene::BackdropKind ReadKind(toml::Section& section) {
  const std::string name = section.TextOr("kind", kKinds[0]);
  const auto known = std::ranges::find(kKinds, name);
  if (known == kKinds.end()) {
    section.Fault("kind",
                  fmt::format("there is no kind \"{}\"; kinds are {}", name, fmt::join(kKinds, ", ")));
    return {};
  }
  const auto kind = static_cast<scene::BackdropKind>(known - kKinds.begin());
  if (kind == scene::BackdropKind::kPicture)
    section.Fault("kind", "a picture is named by picture = \"file.png\"");
  return kind;
}

// `otherwise` where the text is no colour, so that reading goes on.
glm::vec3 ReadColour(toml::Section& section, std::string_view key, glm::vec3 otherwise) {
  const std::string text = section.Text(key);
  const auto colour = ColourOf(text);
  if (!colour) section.Fault(key, fmt::format("\"{}\" is no colour; write one as \"#41506a\"", text));
  return colour.value_or(otherwise);
}

// The texture's number; -1, and a fault, where there is none.
int ReadPicture(toml::Section& section, const std::filesystem::path& folder,
                std::vector<face::Texture>& textures) {
  const std::string name = section.Text("picture");
  if (name.empty()) {
    section.Fault("picture", "must name a PNG file");
    return -1;
  }
  // A path within the show's folder, as authors write it; the tool runs as the author, so nothing is
  // kept from him.
  const auto picture = image::ReadPng(folder / name);
  if (!picture) {
    section.Fault("picture", picture.error().message());
    return -1;
  }
  if (std::max(picture->width_px, picture->height_px) > kWidestPicture_px) {
    section.Fault("picture", fmt::format("{} has {} x {} pixels, and {} a side are the most", name,
                                         picture->width_px, picture->height_px, kWidestPicture_px));
    return -1;
  }
  textures.push_back(TextureOf(*picture));
  return static_cast<int>(textures.size()) - 1;
}

}  // namespace

// A picture may go without colours; everything else is painted with them.
scene::Backdrop ReadBackdrop(toml::Section section, const std::filesystem::path& folder,
                             std::vector<face::Texture>& textures) {
  section.AllowOnly({"kind", "top", "bottom", "glow", "picture"});
  scene::Backdrop backdrop;
  const bool is_picture = section.Has("picture");
  if (is_picture) {
    backdrop.kind = scene::BackdropKind::kPicture;
    backdrop.picture = ReadPicture(section, folder, textures);
  } else {
    backdrop.kind = ReadKind(section);
  }
  if (!is_picture || section.Has("top")) backdrop.top = ReadColour(section, "top", backdrop.top);
  if (!is_picture || section.Has("bottom")) backdrop.bottom = ReadColour(section, "bottom", backdrop.bottom);
  if (section.Has("glow")) backdrop.glow = ReadColour(section, "glow", backdrop.glow);
  return backdrop;
}

// "nothing" for a number that is no kind, so that packs can be compared whatever they hold.
std::string NameOf(scene::BackdropKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  return std::string(index < kKinds.size() ? kKinds[index] : "nothing");
}

}  // namespace kaori::authoring
