#include <fmt/format.h>

#include "drivers/base/markup.h"
#include "hw-sim/hil/report.h"

namespace kaori::hil {
namespace {

// One page, with its style in it: a report is a file that is sent around. It
// follows the reader's dark mode.
constexpr std::string_view kStyle = R"css(
:root { --ink: #1d2129; --soft: #667085; --paper: #f6f4ef; --card: #fff; --line: #e4e0d7;
        --good: #2f7d4f; --bad: #b3372f; --left: #9a7a1f; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #ece8df; --soft: #a39d90; --paper: #16171b; --card: #1f2126; --line: #34363d;
          --good: #6cc08b; --bad: #ef8077; --left: #d8b959; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
       font: 16px/1.5 "Inter", "Segoe UI", "Helvetica Neue", "DejaVu Sans", sans-serif; }
main { max-width: 64rem; margin: 0 auto; padding: 2.5rem 1.25rem 4rem; }
h1 { font-size: 1.9rem; margin: 0; letter-spacing: -.01em; }
.under { color: var(--soft); margin: .3rem 0 1.6rem; overflow-wrap: anywhere; }
.tally { display: grid; grid-template-columns: repeat(auto-fit, minmax(9rem, 1fr)); gap: .8rem; margin-bottom: 2rem; }
.tally div { background: var(--card); border: 1px solid var(--line); border-radius: .6rem; padding: .8rem 1rem; }
.tally b { display: block; font-size: 1.55rem; font-variant-numeric: tabular-nums; }
.tally span { color: var(--soft); font-size: .85rem; }
article { background: var(--card); border: 1px solid var(--line); border-left: .35rem solid var(--mark); border-radius: .6rem;
          padding: 1rem 1.2rem; margin: 0 0 .9rem; }
.passed { --mark: var(--good); } .failed { --mark: var(--bad); } .skipped { --mark: var(--left); }
article header { display: flex; gap: .8rem; align-items: baseline; }
article h2 { font-size: 1.05rem; margin: 0; flex: 1; }
.verdict { color: var(--mark); font-weight: 650; font-size: .85rem; }
.took { color: var(--soft); font-size: .85rem; font-variant-numeric: tabular-nums; }
p.said { margin: .25rem 0 0; color: var(--soft); overflow-wrap: anywhere; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: .7rem; margin-top: .9rem; }
figure { margin: 0; } figure img { width: 100%; display: block; border-radius: .4rem; background: #000; }
figcaption { font-size: .82rem; color: var(--soft); padding-top: .2rem; }
details a { font-size: .8rem; color: var(--soft); } details { margin-top: .6rem; } summary { cursor: pointer; font-size: .9rem; }
pre { overflow: auto; max-height: 24rem; background: var(--paper); border-radius: .4rem; padding: .7rem; font-size: .78rem; }
)css";

std::string_view NameOf(Verdict verdict) {
  if (verdict == Verdict::kPassed) return "passed";
  return verdict == Verdict::kFailed ? "failed" : "skipped";
}

// A number with its meaning under it.
std::string Tile(const std::string& value, std::string_view name) {
  return fmt::format("<div><b>{}</b><span>{}</span></div>\n", Escaped(value), Escaped(name));
}

// A figure's name as people read it.
std::string Spaced(std::string name) {
  for (char& letter : name)
    if (letter == '_') letter = ' ';
  return name;
}

// Pictures are files beside the page, and load as the reader comes to them.
std::string Pictures(const Finding& finding) {
  if (finding.pictures.empty()) return {};
  std::string all = "<div class=\"pictures\">";
  for (const Picture& picture : finding.pictures)
    all += fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" "
        "loading=\"lazy\"></a><figcaption>{1}</figcaption></figure>",
        Escaped(picture.file), Escaped(picture.caption));
  return all + "</div>\n";
}

// Each text is in the page, folded, and a file of its own for those who search.
std::string Texts(const ReportedCheck& check) {
  std::string all;
  for (const auto& [name, text] : check.finding.texts)
    all += fmt::format("<details><summary>{}</summary><pre>{}</pre><a href=\"{}\">as a file</a></details>\n",
                       Escaped(name), Escaped(text), Escaped(TextFile(check.name, name)));
  return all;
}

// One check: its verdict, its sentence, what was seen, its pictures and texts.
std::string Article(const ReportedCheck& check) {
  const std::string_view word = NameOf(check.finding.verdict);
  return fmt::format(
      "<article class=\"{0}\" id=\"{1}\"><header><h2>{2}</h2><span class=\"took\">{3:.1f} s</span><span "
      "class=\"verdict\">{0}</span></header>\n<p class=\"said\">{4}</p>\n{5}{6}</article>\n",
      word, Escaped(check.name), Escaped(check.sentence), check.finding.took_s, Escaped(check.finding.Said()),
      Pictures(check.finding), Texts(check));
}

// The tallies, the start's time, and then each figure of each check, to four
// digits: MergeFigures writes them whole.
std::string Tiles(const Report& report) {
  std::string tiles = Tile(std::to_string(report.count(Verdict::kPassed)), "checks passed");
  tiles += Tile(std::to_string(report.count(Verdict::kFailed)), "failed");
  if (const int skipped = report.count(Verdict::kSkipped); skipped > 0)
    tiles += Tile(std::to_string(skipped), "skipped");
  tiles += Tile(fmt::format("{:.0f} s", report.boot_s), "from power to the face");
  for (const ReportedCheck& check : report.checks)
    for (const auto& [name, value] : check.finding.Measured())
      tiles += Tile(fmt::format("{:.4g}", value), Spaced(name));
  return tiles;
}

}  // namespace

std::string AsPage(const Report& report) {
  // A run without a check counts as good, and says so by its numbers.
  const bool good = report.count(Verdict::kFailed) == 0;
  std::string articles;
  for (const ReportedCheck& check : report.checks) articles += Article(check);
  const std::string hash = report.root_hash.empty() ? "" : ", root " + report.root_hash;
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>The box on the "
      "bench</title><style>{}</style></head><body><main>\n"
      "<h1>{}</h1>\n<p class=\"under\">{}{}</p>\n<div class=\"tally\">\n{}</div>\n{}</main></body></html>\n",
      kStyle, good ? "The box plays on the bench" : "The box failed on the bench", Escaped(report.image),
      Escaped(hash), Tiles(report), articles);
}

}  // namespace kaori::hil
