#include "appliance/authoring/pack/check_folder.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/authoring/script/show_file.h"
#include "appliance/authoring/sculpt/control_net.h"
#include "appliance/authoring/sculpt/expression_file.h"
#include "appliance/authoring/sculpt/faces.h"
#include "appliance/authoring/sculpt/recipe_file.h"
#include "appliance/authoring/sculpt/sculpt.h"
#include "appliance/authoring/sculpt/value.h"
#include "appliance/authoring/appearance/looks.h"
#include "appliance/core/show/check.h"
#include "render/face/check.h"

namespace kaori::authoring {
namespace {

using Names = std::optional<std::vector<std::string>>;  // None: the file cannot tell.

const sculpt::Value* Find(const sculpt::Value& table, std::string_view key) {
  for (const auto& [name, value] : table.table)
    if (name == key) return &value;
  return nullptr;
}

// The words of a list, or what its tables say under "name".
Names NamesIn(const std::filesystem::path& file, std::string_view list) {
  const auto value = sculpt::ReadToml(file);
  const sculpt::Value* items = value ? Find(*value, list) : nullptr;
  if (items == nullptr) return std::nullopt;
  std::vector<std::string> names;
  for (const sculpt::Value& item : items->list) {
    const sculpt::Value* name = item.kind == sculpt::Value::Kind::kTable ? Find(item, "name") : &item;
    if (name != nullptr) names.push_back(name->word);
  }
  return names;
}

// Where an expression's points would lie on a face that could not be sculpted: somewhere that is allowed, so
// that the rest of the file can be read.
sculpt::HalfShape StandIn(const sculpt::Cage& cage) {
  const std::size_t vertices = cage.half.keys.size();
  return {std::vector<glm::dvec3>(vertices), std::vector<glm::dvec2>(vertices, glm::dvec2(1, 0))};
}

// What CheckShow may look up of a cast whose faces or expressions could not be made.
face::Cast NamedCast(const Names& faces, const Names& expressions) {
  face::Cast cast;
  if (faces)
    for (const std::string& name : *faces) cast.faces.emplace_back().name = name;
  if (expressions)
    for (const std::string& name : *expressions) cast.expressions.emplace_back().name = name;
  return cast;
}

class Checker {
 public:
  explicit Checker(std::filesystem::path folder)
      : folder_(std::move(folder)),
        faces_(NamesIn(folder_ / "faces" / "cast.toml", "faces")),
        expressions_(NamesIn(folder_ / "expressions.toml", "expression")) {}

  std::vector<std::string> Check() {
    CheckShapes();
    CheckLooks();
    CheckScript(faults_.empty() ? Sculpted() : std::nullopt);
    return std::move(faults_);
  }

 private:
  template <class T>
  std::optional<T> Keep(Result<T> made, const std::string& file = "") {
    if (made) return std::move(*made);
    AddLines(made.error().message(), file);
    return std::nullopt;
  }

  void AddLines(std::string_view lines, const std::string& file) {
    while (!lines.empty()) {
      const std::string_view line = lines.substr(0, lines.find('\n'));
      faults_.push_back(file.empty() ? std::string(line) : fmt::format("{}: {}", file, line));
      lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    }
  }

  void CheckShapes() {
    const sculpt::Cage cage = sculpt::BuildCage();
    const auto recipe = Keep(sculpt::ReadCastRecipe(folder_ / "faces"));
    const auto reference = recipe ? CheckFaces(cage, *recipe) : std::nullopt;
    const std::filesystem::path path = folder_ / "expressions.toml";
    const auto file = Keep(sculpt::ReadExpressionFile(path, cage.half, reference.value_or(StandIn(cage))));
    if (file && reference) Keep(sculpt::MakeControlNet(cage, *reference, *file), path.string());
  }

  // Each face beside the first, on which the others are built. Returns the first one's shape.
  std::optional<sculpt::HalfShape> CheckFaces(const sculpt::Cage& cage, const sculpt::CastRecipe& recipe) {
    if (auto all = sculpt::ShapeFaces(cage, recipe)) return std::move(all->front().shape);
    std::optional<sculpt::HalfShape> reference;
    for (std::size_t i = 0; i < recipe.faces.size(); ++i) {
      sculpt::CastRecipe pair{.aim = recipe.aim, .faces = {recipe.faces.front()}};
      if (i > 0) pair.faces.push_back(recipe.faces[i]);
      auto shaped = Keep(sculpt::ShapeFaces(cage, pair));
      if (i > 0) continue;
      if (!shaped) return std::nullopt;
      reference = std::move(shaped->front().shape);
    }
    return reference;
  }

  void CheckLooks() {
    for (const std::string& name : faces_.value_or(std::vector<std::string>{}))
      Keep(appearance::ReadLook(folder_ / "looks" / (name + ".toml")));
  }

  std::optional<face::Cast> Sculpted() {
    face::Cast cast;
    if (const auto ok = sculpt::Sculpt(folder_, cast); !ok) AddLines(ok.error().message(), "");
    return faults_.empty() ? std::optional(std::move(cast)) : std::nullopt;
  }

  // The script is checked beside the cast, or beside its names alone where the cast could not be made.
  void CheckScript(std::optional<face::Cast> cast) {
    const std::string path = (folder_ / "show.toml").string();
    show::Show show;
    show.cast = cast ? std::move(*cast) : NamedCast(faces_, expressions_);
    show.cast.textures = {{1, 1, std::vector<std::uint8_t>(4)}};  // The painter's work is not done yet.
    for (const std::string& fault : ReadShowFile(path, show)) AddOfScript(fault);
    const auto of_cast = face::FindFaults(show.cast);
    const auto all = show::CheckShow(show);  // Those of the cast first.
    if (cast)
      for (const std::string& fault : of_cast)
        faults_.push_back(fmt::format("{}: {}", folder_.string(), fault));
    for (std::size_t i = of_cast.size(); i < all.size(); ++i)
      AddOfScript(fmt::format("{}: {}", path, all[i]));
  }

  // Where nobody knows which faces or expressions there are, none can be said to be missing.
  void AddOfScript(const std::string& fault) {
    const bool unknown_face = !faces_ && Holds(fault, {"there is no face "});
    const bool unknown_expression =
        !expressions_ && Holds(fault, {"there is no expression ", "there is no target or channel ",
                                       "a curve moves nothing that exists"});
    const bool unknown_number = (!faces_ || !expressions_) && Holds(fault, {": calls number "});
    if (!unknown_face && !unknown_expression && !unknown_number) faults_.push_back(fault);
  }
  static bool Holds(std::string_view fault, std::initializer_list<std::string_view> any_of) {
    return std::ranges::any_of(any_of,
                               [fault](auto words) { return fault.find(words) != std::string_view::npos; });
  }

  std::filesystem::path folder_;
  Names faces_;
  Names expressions_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> CheckFolder(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) return {folder.string() + ": there is no such folder"};
  return Checker(folder).Check();
}

std::string JoinFaults(const std::vector<std::string>& faults) {
  return fmt::format("{}", fmt::join(faults, "\n"));
}

}  // namespace kaori::authoring
