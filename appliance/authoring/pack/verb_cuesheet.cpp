#include "appliance/authoring/pack/cue_sheet.h"
#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/program.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

// English where no language was asked for. Errors: invalid_argument, for any other word than the two.
Result<SheetLanguage> LanguageNamed(const Arguments& arguments) {
  const auto given = arguments.options.find("--language");
  if (given == arguments.options.end() || given->second == "en") return SheetLanguage::kEnglish;
  if (given->second == "ja") return SheetLanguage::kJapanese;
  return FailInput("--language is en or ja, not " + given->second);
}

// Silent where all is well; the page is written whole or not at all.
int RunCueSheet(const Arguments& arguments) {
  const auto language = LanguageNamed(arguments);
  if (!language) return ExitWithError(language.error());
  const auto show = show::LoadPack(arguments.words[0]);
  if (!show) return ExitWithError(show.error());
  const std::string page = CueSheet(*show, *language);
  if (const auto ok = WriteWholeFile(arguments.words[1], {AsBytes(page)}); !ok)
    return ExitWithError(ok.error());
  return 0;
}

}  // namespace

Verb CueSheetVerb() {
  return {.name = "cuesheet",
          .words = {"FILE", "HTML"},
          .options = {{"--language", "LANGUAGE"}},
          .summary = "the cue list of a pack, to print on A4 paper",
          .page = R"(
One page of HTML that a browser prints: the cues by act, what begins each, what happens and in how many seconds, the
notes, and room for a pencil.

  --language LANGUAGE   en or ja: the sheet's own words; English where it is not given. Names and notes stand as the show has them
)",
          .run = RunCueSheet};
}

}  // namespace kaori::authoring
