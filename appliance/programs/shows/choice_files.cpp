#include "appliance/programs/shows/choice_files.h"

#include "drivers/base/whole_file.h"

namespace kaori::shows {

// A text that is damaged or cut short is not sound, and counts as none.
bool HasChoice(const Folder& folder) {
  return store::NewerSound(folder.Read(store::kChoiceFiles[0]), folder.Read(store::kChoiceFiles[1]))
      .has_value();
}

// Both are read each time: which of them counts is said by their generations alone.
store::Choice ReadChoice(const Folder& folder) {
  return store::Newer(folder.Read(store::kChoiceFiles[0]), folder.Read(store::kChoiceFiles[1]));
}

// Content, name, folder, in this order; a name that reached the disk before its content would be a torn
// choice.
Result<void> WriteChoice(Folder& folder, const store::Choice& choice) {
  const std::string text = store::Format(choice);
  auto draft = folder.Begin(kNewChoice);
  if (!draft) return tl::unexpected(draft.error());
  if (auto ok = (*draft)->Append(AsBytes(text)); !ok) return ok;
  if (auto ok = (*draft)->Finish(); !ok) return ok;
  // The two files take turns by the generation, so that the choice before stays whole.
  if (auto ok = folder.Rename(kNewChoice, store::kChoiceFiles[choice.generation % 2]); !ok) return ok;
  return folder.KeepNames();
}

}  // namespace kaori::shows
