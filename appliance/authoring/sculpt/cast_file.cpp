#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "appliance/authoring/sculpt/recipe_file.h"
#include "appliance/authoring/sculpt/recipe_parts.h"
#include "appliance/core/toml/nearest.h"
#include "drivers/base/folder.h"

namespace kaori::sculpt {
namespace {

// Whether the face that is read may be like another one. A face is like another one, and that one like none,
// so that no circle can arise.
enum class Borrowing { kAllowed, kRefused };

Result<FaceRecipe> ReadFace(const std::filesystem::path& path, Borrowing borrowing);

// Other faces of the folder that this one may have meant, as a hint for the fault; empty where the one that
// it names is there.
std::string OtherFaces(const std::filesystem::path& model) {
  if (IsThere(model)) return "";
  std::vector<std::string> names;
  for (const auto& path : ListFolder(model.parent_path()).value_or(std::vector<std::filesystem::path>{}))
    if (path.extension() == ".toml" && path.stem() != "cast") names.push_back(path.stem().string());
  return fmt::format("; there is no face \"{}\"{}", model.stem().string(),
                     toml::DidYouMean(model.stem().string(), {names.begin(), names.end()}));
}

// The face that `file` says it is like; one without a name where that cannot be. The other file's own faults
// are not repeated: it is read, and reported, by itself.
FaceRecipe ReadModel(toml::Section& file, const std::filesystem::path& folder, Borrowing borrowing) {
  const std::filesystem::path model = folder / (file.Text("like") + ".toml");
  Result<FaceRecipe> other = tl::unexpected(Error{});
  if (borrowing == Borrowing::kAllowed) other = ReadFace(model, Borrowing::kRefused);
  if (other && std::holds_alternative<Carved>(other->shape)) return std::move(*other);
  file.Fault("like", "must name a valid, carved face that is like no other" + OtherFaces(model));
  return {.name = "", .file = "", .shape = Carved{}};
}

// One face's file. The name is the caller's to set. Errors: the file's faults, one a line.
Result<FaceRecipe> ReadFace(const std::filesystem::path& path, Borrowing borrowing) {
  const Result<toml::Value> value = toml::ReadToml(path);
  if (!value) return tl::unexpected(value.error());
  toml::Faults faults(path.string());
  toml::Section file(*value, "", faults);
  FaceRecipe face{.name = "", .file = path.string(), .shape = Carved{}};
  if (file.Has("like")) face = ReadModel(file, path.parent_path(), borrowing);
  face.file = path.string();
  ReadShape(file, face);
  if (file.Has("mouth_fit")) ReadMouthFit(file.Part("mouth_fit"), face);
  face.expression_gain = file.NumberOr("expression_gain", face.expression_gain);
  const Result<void> verdict = faults.Verdict();
  if (!verdict) return tl::unexpected(verdict.error());
  return face;
}

// What is wrong with several files, one a line: an author mends all of them at once.
struct Complaints {
  std::string text;

  template <class T>
  void Hear(const Result<T>& result) {
    if (!result) text += (text.empty() ? "" : "\n") + result.error().message();
  }
};

}  // namespace

// All faces are read, whatever is wrong with the first, so that an author mends all faults at once.
Result<CastRecipe> ReadCastRecipe(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "cast.toml";
  const Result<toml::Value> value = toml::ReadToml(path);
  if (!value) return tl::unexpected(value.error());
  toml::Faults faults(path.string());
  toml::Section file(*value, "", faults);
  file.AllowOnly({"faces", "aim"});
  CastRecipe cast{.aim = ReadAim(file.Part("aim")), .faces = {}};
  const std::vector<std::string> names = file.Texts("faces");
  if (names.empty()) file.Fault("faces", "there must be one at least");
  for (auto name = names.begin(); name != names.end(); ++name)
    if (std::find(names.begin(), name, *name) != name)
      file.Fault("faces", "\"" + *name + "\" is given twice");
  Complaints complaints;
  complaints.Hear(faults.Verdict());
  const toml::Value* list = file.Find("faces");
  for (const std::string& name : names) {
    const std::filesystem::path face_file = folder / (name + ".toml");
    Result<FaceRecipe> face = ReadFace(face_file, Borrowing::kAllowed);
    // The list names a file that is not there: that is a fault of the list, at its line.
    if (!face && !IsThere(face_file))
      face = FailInput(
          fmt::format("{}:{}: faces: \"{}\": {}", path.string(), list->line, name, face.error().message()));
    complaints.Hear(face);
    if (!face) continue;
    face->name = name;
    cast.faces.push_back(std::move(*face));
  }
  if (!complaints.text.empty()) return FailInput(complaints.text);
  if (!std::holds_alternative<Carved>(cast.faces.front().shape)) {
    return FailInput(cast.faces.front().file + ": shape: the first face must be \"carved\"");
  }
  return cast;
}

}  // namespace kaori::sculpt
