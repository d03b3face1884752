#include "appliance/core/backup/contents.h"

#include <algorithm>

#include <fmt/format.h>

#include "appliance/core/backup/sha256.h"
#include "appliance/core/restore/kept.h"
#include "appliance/core/show/pack_container.h"
#include "appliance/core/store/choice.h"
#include "drivers/base/number.h"
#include "drivers/base/whole_file.h"

namespace kaori::backup {
namespace {

constexpr std::string_view kHead = "kaori-backup ", kSum = "sum ", kBox = "box ", kMade = "made ",
                           kShow = "show ";
constexpr std::size_t kLongestText = 100;

auto Damaged() {
  return FailInput("has a damaged list of contents");
}

std::string SumOf(std::string_view text) {
  Sha256 sum;
  sum.Add(AsBytes(text));
  return sum.Finish();
}

// Cuts the first line off; nothing where the text does not end it.
std::optional<std::string_view> CutLine(std::string_view& text) {
  const auto end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const auto line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

// The text behind `word` on the next line, where the line begins with it and is not too long.
bool CutWord(std::string_view& text, std::string_view word, std::string& into) {
  const auto line = CutLine(text);
  if (!line || !line->starts_with(word) || line->size() > word.size() + kLongestText) return false;
  into = line->substr(word.size());
  return true;
}

// The longest that is believed depends on what it is; a path that is none of a box's is refused, whatever its length.
Result<void> CheckMember(const Member& member) {
  const std::string& path = member.path;
  std::uint64_t most = kLargestFile_bytes;
  if (restore::IsPack(path))
    most = show::kLargestPack_bytes;
  else if (restore::IsReport(path))
    most = kLargestReport_bytes;
  else if (!restore::IsRestored(path))
    return FailInput("has a file that is none of a box's: " + path, kOutsideBackup);
  if (member.bytes > most) return FailInput("is too large: " + path, std::errc::file_too_large);
  return {};
}

// "SHA256 BYTES PATH". A path may have blanks.
Result<Entry> ParseEntry(std::string_view line) {
  const auto first = line.find(' ');
  const auto second = first == std::string_view::npos ? first : line.find(' ', first + 1);
  if (second == std::string_view::npos || !store::IsId(line.substr(0, first))) return Damaged();
  const auto bytes = ParseNumber<std::uint64_t>(line.substr(first + 1, second - first - 1));
  if (!bytes) return Damaged();
  Entry entry{{std::string(line.substr(second + 1)), *bytes}, std::string(line.substr(0, first))};
  if (auto ok = CheckMember(entry.member); !ok) return tl::unexpected(ok.error());
  return entry;
}

// No path twice, the chosen show's pack and no other one, and reports within their bound.
Result<void> CheckWhole(const Contents& contents) {
  std::vector<std::string_view> paths;
  std::uint64_t reports_bytes = 0;
  std::size_t packs = 0;
  for (const Entry& entry : contents.files) {
    paths.push_back(entry.member.path);
    if (restore::IsReport(entry.member.path)) reports_bytes += entry.member.bytes;
    if (restore::IsPack(entry.member.path)) ++packs;
  }
  std::ranges::sort(paths);
  if (std::ranges::adjacent_find(paths) != paths.end()) return Damaged();
  if (reports_bytes > kMostReports_bytes) return FailInput("has too many reports", std::errc::file_too_large);
  const bool of_root = contents.show == store::kRootShow;
  if (!of_root && !store::IsId(contents.show)) return Damaged();
  const std::string pack = "shows/" + store::PackName(contents.show);
  const bool has_its_pack = of_root ? packs == 0 : packs == 1 && std::ranges::binary_search(paths, pack);
  return has_its_pack ? Result<void>{} : Damaged();
}

}  // namespace

// The checksum is of all lines before it. Whoever changes one has to make it anew, as sha256sum does.
std::string Format(const Contents& contents) {
  std::string text = fmt::format("{}{}\n{}{}\n{}{}\n{}{}\n", kHead, kBackupVersion, kBox, contents.box, kMade,
                                 contents.made, kShow, contents.show);
  for (const Entry& entry : contents.files)
    text += fmt::format("{} {} {}\n", entry.sha256, entry.member.bytes, entry.member.path);
  return text + std::string(kSum) + SumOf(text) + "\n";
}

// The version before the checksum: a newer one may have another.
Result<Contents> ParseContents(std::string_view text) {
  std::string version;
  std::string_view rest = text;
  if (!CutWord(rest, kHead, version)) return FailInput("is no backup of a box", kNoBackup);
  const auto number = ParseNumber<int>(version);
  if (!number) return Damaged();
  if (*number > kBackupVersion) return FailInput("is of version " + std::to_string(*number), kNewerBackup);
  const auto sum_at = text.rfind(kSum);
  if (*number < 1 || sum_at == std::string_view::npos ||
      text.substr(sum_at) != std::string(kSum) + SumOf(text.substr(0, sum_at)) + "\n")
    return Damaged();
  rest.remove_suffix(text.size() - sum_at);
  Contents contents;
  if (!CutWord(rest, kBox, contents.box) || !CutWord(rest, kMade, contents.made) ||
      !CutWord(rest, kShow, contents.show))
    return Damaged();
  while (!rest.empty()) {
    const auto line = CutLine(rest);
    if (!line) return Damaged();
    if (contents.files.size() == kMostFiles)
      return FailInput("has too many files", std::errc::file_too_large);
    auto entry = ParseEntry(*line);
    if (!entry) return tl::unexpected(entry.error());
    contents.files.push_back(std::move(*entry));
  }
  if (auto ok = CheckWhole(contents); !ok) return tl::unexpected(ok.error());
  return contents;
}

}  // namespace kaori::backup
