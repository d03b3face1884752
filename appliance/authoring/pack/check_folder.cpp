#include "appliance/authoring/pack/check_folder.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/authoring/appearance/looks.h"
#include "appliance/authoring/inspect/inspect.h"
#include "appliance/authoring/script/show_file.h"
#include "appliance/authoring/sculpt/control_net.h"
#include "appliance/authoring/sculpt/expression_file.h"
#include "appliance/authoring/sculpt/faces.h"
#include "appliance/authoring/sculpt/recipe_file.h"
#include "appliance/authoring/sculpt/sculpt.h"
#include "appliance/core/show/check.h"
#include "appliance/core/toml/value.h"
#include "drivers/base/folder.h"

namespace kaori::authoring {
namespace {

// A name that a file gives, with its line.
struct NamedLine {
  std::string name;
  int line = 0;
};
// None: the file cannot tell, since it cannot be read or lacks the list.
using Names = std::optional<std::vector<NamedLine>>;

// The texts of a list, or what its tables say under "name". Reads the file once more than the readers do, so
// that names are known even where those find faults.
Names NamesIn(const std::filesystem::path& file, std::string_view list) {
  const auto value = toml::ReadToml(file);
  const toml::Value* items = value ? toml::Find(*value, list) : nullptr;
  if (items == nullptr) return std::nullopt;
  std::vector<NamedLine> names;
  for (const toml::Value& item : items->list) {
    const toml::Value* name = item.kind == toml::Value::Kind::kTable ? toml::Find(item, "name") : &item;
    if (name != nullptr) names.push_back({name->text, name->line});
  }
  return names;
}

bool Holds(const std::vector<NamedLine>& names, std::string_view name) {
  return std::ranges::find(names, name, &NamedLine::name) != names.end();
}

// Where an expression's points would lie on a face that could not be sculpted: somewhere that is allowed, so
// that the rest of the file can be read.
sculpt::HalfShape StandIn(const sculpt::Cage& cage) {
  const std::size_t vertices = cage.half.keys.size();
  return {std::vector<glm::dvec3>(vertices), std::vector<glm::dvec2>(vertices, glm::dvec2(1, 0))};
}

// What CheckShow and the script may look up of a cast whose faces or expressions could not be
// made: the names.
face::Cast NamedCast(const Names& faces, const Names& expressions) {
  face::Cast cast;
  if (faces)
    for (const NamedLine& face : *faces) cast.faces.emplace_back().name = face.name;
  if (expressions)
    for (const NamedLine& expression : *expressions) cast.expressions.emplace_back().name = expression.name;
  return cast;
}

// Runs all readers, and keeps what each of them says. Used once. Each step goes on without what an earlier
// one could not make.
class Checker {
 public:
  explicit Checker(std::filesystem::path folder)
      : folder_(std::move(folder)),
        faces_(NamesIn(folder_ / "faces" / "cast.toml", "faces")),
        expressions_(NamesIn(folder_ / "expressions.toml", "expression")) {}

  // Shapes, looks, names, script: each fault is told once, by the first step that finds it.
  FolderCheck Check() {
    CheckShapes();
    CheckLooks();
    if (faces_) CheckThatAllAreNamed("faces");
    if (faces_) CheckThatAllAreNamed("looks");
    // A cast is only worth making of files without a fault.
    const std::optional<face::Cast> cast = faults_.empty() ? Sculpted() : std::nullopt;
    CheckScript(cast);
    FolderCheck check{std::move(faults_), {}};
    if (check.faults.empty() && cast) check.flaws = FlawsOf(*cast);
    return check;
  }

 private:
  // The value, or none and its fault's lines, `file` before each where the fault does not name it itself.
  template <class T>
  std::optional<T> Keep(Result<T> made, const std::string& file = "") {
    if (made) return std::move(*made);
    AddLines(made.error().message(), file);
    return std::nullopt;
  }

  // Errors hold one fault a line; each becomes an entry.
  void AddLines(std::string_view lines, const std::string& file) {
    while (!lines.empty()) {
      const std::string_view line = lines.substr(0, lines.find('\n'));
      faults_.push_back(file.empty() ? std::string(line) : fmt::format("{}: {}", file, line));
      lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    }
  }

  // Expressions are read even where the reference face could not be made: a stand-in then says
  // where vertices lie.
  void CheckShapes() {
    const sculpt::Cage cage = sculpt::BuildCage();
    const auto recipe = Keep(sculpt::ReadCastRecipe(folder_ / "faces"));
    const auto reference = recipe ? CheckFaces(cage, *recipe) : std::nullopt;
    const std::filesystem::path path = folder_ / "expressions.toml";
    const auto file = Keep(sculpt::ReadExpressionFile(path, cage.half, reference.value_or(StandIn(cage))));
    if (file && reference) Keep(sculpt::MakeControlNet(cage, *reference, *file), path.string());
  }

  // ShapeFaces ends at the first fault, so each face is made beside the first, on which the others are built.
  // Returns the first one's shape; none where that has a fault.
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

  // A face without a look is a fault of the list that names it, at its line.
  void CheckLooks() {
    for (const NamedLine& face : faces_.value_or(std::vector<NamedLine>{})) {
      const std::filesystem::path file = folder_ / "looks" / (face.name + ".toml");
      if (IsThere(file))
        Keep(appearance::ReadLook(file));
      else
        faults_.push_back(fmt::format("{}:{}: faces: \"{}\" has no look: {}: No such file", CastFile(),
                                      face.line, face.name, file.string()));
    }
  }

  std::string CastFile() const { return (folder_ / "faces" / "cast.toml").string(); }

  // A file that no name leads to would be passed over in silence.
  void CheckThatAllAreNamed(const char* kind) {
    for (const auto& path : ListFolder(folder_ / kind).value_or(std::vector<std::filesystem::path>{})) {
      const std::string name = path.stem().string();
      if (path.extension() == ".toml" && name != "cast" && !Holds(*faces_, name))
        faults_.push_back(fmt::format("{}:{}: faces: does not name \"{}\", though {} is there", CastFile(),
                                      faces_->empty() ? 1 : faces_->front().line, name, path.string()));
    }
  }

  // For faults that no reader has found; there should be none.
  std::optional<face::Cast> Sculpted() {
    face::Cast cast;
    if (const auto ok = sculpt::Sculpt(folder_, cast); !ok) AddLines(ok.error().message(), "");
    return faults_.empty() ? std::optional(std::move(cast)) : std::nullopt;
  }

  // The script is checked beside the cast, or beside its names alone where the cast could not be made;
  // CheckShow then would complain of everything.
  void CheckScript(const std::optional<face::Cast>& cast) {
    const std::string path = (folder_ / "show.toml").string();
    show::Show show;
    show.cast = cast ? *cast : NamedCast(faces_, expressions_);
    // The painter's work is not done yet: one texel stands for the skins, which faces number.
    show.cast.textures = {{1, 1, std::vector<std::uint8_t>(4)}};
    const auto of_script =
        ReadShowFile(path, show, {.faces = faces_.has_value(), .expressions = expressions_.has_value()});
    std::ranges::copy(of_script, std::back_inserter(faults_));
    if (!cast || !of_script.empty()) return;
    for (const std::string& fault : show::CheckShow(show))
      faults_.push_back(fmt::format("{}: {}", folder_.string(), fault));
  }

  // Expressions that fold the skin of any face, with their lines; of a face that folds at rest that alone is
  // said, since every pose of it folds.
  std::vector<std::string> FlawsOf(const face::Cast& cast) const {
    struct Folds {
      int triangles = 0;
      std::vector<std::string> faces;
    };
    std::map<std::string, Folds> by_pose;
    std::vector<std::string> flaws, at_rest;
    const std::string& rest = cast.expressions.front().name;
    const auto ignore = [](const std::string&) {};
    const inspect::Inspection inspection = inspect::Inspect(cast, ignore, inspect::Scope::kFoldsAlone);
    for (const inspect::Finding& f : inspection.findings) {
      if (std::ranges::find(at_rest, f.face) != at_rest.end()) continue;
      if (f.pose == rest) {
        at_rest.push_back(f.face);
        flaws.push_back(fmt::format("{}: its skin is folded at rest, in {} triangles",
                                    (folder_ / "faces" / (f.face + ".toml")).string(), f.count));
        continue;
      }
      by_pose[f.pose].triangles += f.count;
      by_pose[f.pose].faces.push_back(f.face);
    }
    // In the file's order, whatever the order of faces was.
    for (const NamedLine& expression : expressions_.value_or(std::vector<NamedLine>{}))
      if (const auto folds = by_pose.find(expression.name); folds != by_pose.end())
        flaws.push_back(
            fmt::format("{}:{}: expression \"{}\": folds the skin of {}, in {} triangles: pull the points "
                        "beside along, or pull less",
                        (folder_ / "expressions.toml").string(), expression.line, expression.name,
                        fmt::join(folds->second.faces, ", "), folds->second.triangles));
    return flaws;
  }

  std::filesystem::path folder_;
  Names faces_;
  Names expressions_;
  std::vector<std::string> faults_;
};

}  // namespace

FolderCheck CheckFolder(const std::filesystem::path& folder) {
  // One line instead of one for each file that is not there.
  if (!std::filesystem::is_directory(folder)) return {{folder.string() + ": there is no such folder"}, {}};
  return Checker(folder).Check();
}

std::string JoinFaults(const std::vector<std::string>& faults) {
  return fmt::format("{}", fmt::join(faults, "\n"));
}

}  // namespace kaori::authoring
