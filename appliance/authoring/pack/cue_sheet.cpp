#include "appliance/authoring/pack/cue_sheet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drivers/base/markup.h"
#include "render/scene/scene.h"

namespace kaori::authoring {
namespace {

// What the sheet says itself. In the formats, {0} is a name or a value and {1} a time in seconds.
// The rules have the scene of PANIC as {0}, the guard of GO as {1}, and the time of a jump as {2}.
struct Words {
  const char *language, *title, *cue, *begins, *happens, *notes;
  const char *go, *with_previous, *after_previous, *then_waits, *or_after;
  const char *mouth_shut, *voice_quiet, *presence, *gaze_on;
  const char *layer, *larger, *from;
  const char *scene, *face, *expression, *style, *light, *present, *absent, *motion, *sounding, *looping,
      *no_motion;
  const char *at_once, *in_time;
  const char* rules;
};

// A text may leave out one of its values, but {0} and {1} mean the same in both languages.
constexpr Words kEnglish{
    .language = "en",
    .title = "Cue sheet",
    .cue = "Cue",
    .begins = "Begins",
    .happens = "What happens",
    .notes = "Notes",
    .go = "GO",
    .with_previous = "with the cue before",
    .after_previous = "when the cue before has ended",
    .then_waits = "{0}, then {1} s",
    .or_after = "{0}, or after {1} s",
    .mouth_shut = "mouth shut for {1} s",
    .voice_quiet = "voice quiet for {1} s",
    .presence = "somebody there for {1} s",
    .gaze_on = "her look on {0} for {1} s",
    .layer = "{0}, {1}",
    .larger = "{0}, {1} times as large",
    .from = "{0}, from {1} s on",
    .scene = "scene {0}",
    .face = "face {0}",
    .expression = "expression {0}",
    .style = "style {0}",
    .light = "light {0} %",
    .present = "she comes into the picture",
    .absent = "she leaves the picture",
    .motion = "motion {0}",
    .sounding = "motion {0}, with sound",
    .looping = "motion {0}, again and again",
    .no_motion = "motions end",
    .at_once = "{0}, at once",
    .in_time = "{0}, {1} s",
    .rules = "A second GO within {1} s is refused. A jump to a cue takes {2} s. PANIC goes to the scene {0}.",
};

// Both tables have all fields: a text that is missing in one of them would be a null pointer.
constexpr Words kJapanese{
    .language = "ja",
    .title = "キューシート",
    .cue = "キュー",
    .begins = "きっかけ",
    .happens = "内容",
    .notes = "メモ",
    .go = "GO",
    .with_previous = "前のキューと同時",
    .after_previous = "前のキューの終わり",
    .then_waits = "{0}、{1} 秒後",
    .or_after = "{0}、または {1} 秒後",
    .mouth_shut = "口が {1} 秒閉じたら",
    .voice_quiet = "声が {1} 秒止んだら",
    .presence = "人が {1} 秒いたら",
    .gaze_on = "視線が {0} に {1} 秒とどまったら",
    .layer = "{0}、{1}",
    .larger = "{0}、{1} 倍",
    .from = "{0}、{1} 秒から",
    .scene = "場面 {0}",
    .face = "顔 {0}",
    .expression = "表情 {0}",
    .style = "描き方 {0}",
    .light = "明かり {0} %",
    .present = "画面に現れる",
    .absent = "画面から消える",
    .motion = "動き {0}",
    .sounding = "動き {0}(音つき)",
    .looping = "動き {0}(くり返し)",
    .no_motion = "動きを止める",
    .at_once = "{0}、カット",
    .in_time = "{0}、{1} 秒",
    .rules = "GO の後 {1} 秒間の GO は受けつけません。キューへの移動は {2} 秒。PANIC の場面は {0}。",
};

// A4, with a heading that every page repeats; a cue is not torn between pages.
constexpr std::string_view kSheetStyle = R"(
@page { size: A4; margin: 14mm 12mm; }
body { font: 10.5pt/1.35 "Noto Sans", "Noto Sans CJK JP", "DejaVu Sans", sans-serif; color: #000; margin: 2em auto; max-width: 186mm; }
@media print { body { margin: 0; } }
h1 { font-size: 16pt; margin: 0; }
p { margin: .2em 0 1em; color: #444; }
table { border-collapse: collapse; width: 100%; }
thead { display: table-header-group; }
tr { break-inside: avoid; }
th { text-align: left; white-space: nowrap; border-bottom: 1.5pt solid #000; padding: 3pt 5pt; }
td { border-bottom: .4pt solid #888; padding: 4pt 5pt; vertical-align: top; }
td.number { font-weight: 700; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.begins { width: 26%; }
td.notes { width: 28%; border-left: .4pt solid #888; }
tr.act { break-after: avoid; }
tr.act th { font-size: 12pt; padding-top: 12pt; border-bottom: .8pt solid #000; }
tr.alone td.begins { font-weight: 700; }
div.name { font-weight: 700; }
ul { margin: 0; padding-left: 1.1em; }
)";

// At most two places behind the point, and none that is not needed.
std::string Number(float value) {
  return fmt::format("{:.4g}", std::round(value * 100) / 100);
}

// Writes one page. Borrows both; the show is one that CheckShow passes, so that indices are used as they are.
class CueSheetWriter {
 public:
  CueSheetWriter(const show::Show& show, const Words& words)
      : show_(show), list_(show.cue_list), words_(words) {}

  // An act's heading stands before its first cue; cues that name no act are of the one before. All names are
  // escaped, since anybody may have made the show.
  std::string Page() const {
    std::string rows, act;
    for (std::size_t i = 0; i < list_.cues.size(); ++i) {
      const show::Cue& cue = list_.cues[i];
      if (!cue.act.empty() && cue.act != act) {
        act = cue.act;
        rows += fmt::format("<tr class=\"act\"><th colspan=\"4\">{}</th></tr>\n", Escaped(act));
      }
      rows += Row(i);
    }
    // A show without scenes can have no panic scene: its name is left empty, since its index points nowhere.
    const std::string rules =
        Say(words_.rules, Escaped(show_.scenes.empty() ? "" : show_.scenes[list_.panic.index].name),
            Number(list_.go_guard_s), Number(list_.goto_s));
    return fmt::format(
        "<!doctype html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"><title>{}: "
        "{}</title><style>{}</style></head><body>\n"
        "<h1>{}: "
        "{}</h1>\n<p>{}</p>\n<table><thead><tr><th>{}</th><th>{}</th><th>{}</th><th>{}</th></tr></"
        "thead><tbody>\n{}"
        "</tbody></table>\n</body></html>\n",
        words_.language, Escaped(show_.name), words_.title, kSheetStyle, Escaped(show_.name), words_.title,
        rules, words_.cue, words_.begins, words_.happens, words_.notes, rows);
  }

 private:
  // Formats are chosen by language when the program runs, so that the compiler cannot check them.
  template <typename... Values>
  static std::string Say(const char* words, const Values&... values) {
    return fmt::format(fmt::runtime(words), values...);
  }

  // What begins a cue is bold where a person calls it, so that whoever calls the show sees at a glance which
  // cues come by themselves.
  std::string Row(std::size_t at) const {
    const show::Cue& cue = list_.cues[at];
    // The first cue has none before it that could play it, so a person always calls it.
    const bool alone = at == 0 || list_.cues[at - 1].next == show::CueNext::kGo;
    std::string happens;
    for (const std::string& line : Lines(cue)) happens += fmt::format("<li>{}</li>", Escaped(line));
    return fmt::format(
        "<tr{}><td class=\"number\">{}</td><td class=\"begins\">{}</td><td><div "
        "class=\"name\">{}</div><ul>{}</ul></td>"
        "<td class=\"notes\">{}</td></tr>\n",
        alone ? " class=\"alone\"" : "", Escaped(cue.number), Escaped(Begins(at)), Escaped(cue.name), happens,
        Escaped(cue.notes));
  }

  // What begins the cue, its pre-wait, and the person for whom it then waits.
  std::string Begins(std::size_t at) const {
    const show::Cue& cue = list_.cues[at];
    // The cue before says how this one begins: `next` of a cue is about the one that follows it.
    const auto before = at == 0 ? show::CueNext::kGo : list_.cues[at - 1].next;
    std::string begins = before == show::CueNext::kContinue ? words_.with_previous
                         : before == show::CueNext::kFollow ? words_.after_previous
                                                            : words_.go;
    if (cue.pre_wait_s > 0) begins = Say(words_.then_waits, begins, Number(cue.pre_wait_s));
    if (cue.wait.person == show::CuePerson::kNobody) return begins;
    const char* person = cue.wait.person == show::CuePerson::kMouthShut    ? words_.mouth_shut
                         : cue.wait.person == show::CuePerson::kVoiceQuiet ? words_.voice_quiet
                         : cue.wait.person == show::CuePerson::kPresence   ? words_.presence
                                                                           : words_.gaze_on;
    // The text of a person has its time as {1}; its {0} is whom a look rests on, and unused by the others.
    const auto target = static_cast<std::size_t>(cue.wait.target);
    const std::string whom = cue.wait.target >= 0 ? show_.gaze_targets[target].name : "";
    const std::string waits =
        Say(words_.or_after, Say(person, whom, Number(cue.wait.for_s)), Number(cue.wait.at_most_s));
    return fmt::format("{}; {}", begins, waits);
  }

  // A fade of no length is told as a cut.
  std::string In(const std::string& what, float in_s) const {
    return in_s > 0 ? Say(words_.in_time, what, Number(in_s)) : Say(words_.at_once, what);
  }

  // In the order in which the performance plays them.
  std::vector<std::string> Lines(const show::Cue& cue) const {
    std::vector<std::string> lines;
    const auto call = [&](const char* words, const std::optional<show::CueCall>& called,
                          const auto& name_of) {
      if (called) lines.push_back(In(Say(words, name_of(called->index)), called->in_s));
    };
    call(words_.scene, cue.scene, [&](auto i) { return show_.scenes[i].name; });
    call(words_.face, cue.face, [&](auto i) { return show_.cast.faces[i].name; });
    call(words_.expression, cue.expression, [&](auto i) { return show_.cast.expressions[i].name; });
    // Styles have no names of their own in a show: those of the renderer are the same on every box.
    call(words_.style, cue.style, [](auto i) { return scene::kStyleNames[i]; });
    if (cue.light) lines.push_back(In(Say(words_.light, Number(cue.light->value * 100)), cue.light->in_s));
    // The value is a target from 0 to 1 of her presence; any above 0 brings her into the picture.
    if (cue.present)
      lines.push_back(In(cue.present->value > 0 ? words_.present : words_.absent, cue.present->in_s));
    // The index is negative where the cue plays no motion, and has a value of its own where it ends them.
    if (cue.motion == show::kEndsMotion) lines.emplace_back(words_.no_motion);
    if (cue.motion >= 0) lines.push_back(LineOfMotion(cue));
    return lines;
  }

  // What the cue says of its motion besides the name. Layers are told in the words of the files.
  std::string LineOfMotion(const show::Cue& cue) const {
    std::string line = Line(show_.motions[static_cast<std::size_t>(cue.motion)]);
    if (cue.use.layer)
      line = Say(words_.layer, line, show::kMotionLayerNames[static_cast<std::size_t>(*cue.use.layer)]);
    if (cue.use.gain != 1) line = Say(words_.larger, line, Number(cue.use.gain));
    if (cue.use.from_s > 0) line = Say(words_.from, line, Number(cue.use.from_s));
    return line;
  }

  // A loop is told before a sound: it goes on until another cue ends it, which the caller must know.
  std::string Line(const show::Motion& motion) const {
    if (motion.Loops()) return Say(words_.looping, motion.name);
    return Say(motion.sound.samples.empty() ? words_.motion : words_.sounding, motion.name);
  }

  const show::Show& show_;
  const show::CueList& list_;
  const Words& words_;
};

}  // namespace

std::string CueSheet(const show::Show& show, SheetLanguage language) {
  return CueSheetWriter(show, language == SheetLanguage::kEnglish ? kEnglish : kJapanese).Page();
}

}  // namespace kaori::authoring
