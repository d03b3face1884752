#include "appliance/core/roles/roles_lines.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/roles/own_buttons.h"
#include "appliance/core/toml/quoted.h"

namespace kaori::roles {
namespace {

std::string_view Trimmed(std::string_view line) {
  const auto begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

// A comment, or nothing at all.
bool SaysNothing(std::string_view line) {
  const std::string_view said = Trimmed(line);
  return said.empty() || said.front() == '#';
}

bool IsText(const toml::Value* value, std::string_view text) {
  return value != nullptr && value->kind == toml::Value::Kind::kText && value->text == text;
}

// The tables of a list, in the order of the file; none where there is no such list.
std::vector<const toml::Value*> TablesOf(const toml::Value& table, std::string_view key) {
  std::vector<const toml::Value*> tables;
  if (const toml::Value* list = toml::Find(table, key))
    for (const toml::Value& one : list->list) tables.push_back(&one);
  return tables;
}

// toml::Value counts from 1.
std::size_t LineOf(const toml::Value& table) {
  return static_cast<std::size_t>(std::max(table.line, 1) - 1);
}

}  // namespace

RolesLines::RolesLines(std::string_view text, std::string file) : file_(std::move(file)) {
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    lines_.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::string RolesLines::text() const {
  return fmt::format("{}\n", fmt::join(lines_, "\n"));
}

std::vector<std::size_t> RolesLines::Begins(const toml::Value& file) const {
  std::vector<std::size_t> begins{lines_.size()};
  for (const char* const key : {"role", "button"})
    for (const toml::Value* table : TablesOf(file, key)) begins.push_back(LineOf(*table));
  std::ranges::sort(begins);
  return begins;
}

Result<RolesLines::Span> RolesLines::SpanOf(const toml::Value& table, std::string_view header,
                                            const std::vector<std::size_t>& begins) const {
  const std::size_t first = LineOf(table);
  if (first < lines_.size() && Trimmed(lines_[first]).starts_with(header))
    return Span{first, *std::ranges::upper_bound(begins, first)};
  return FailInput(
      fmt::format("{}: its roles, maps and buttons are not tables of their own, such as {}: "
                  "nothing can be added to them",
                  file_, header));
}

Result<void> RolesLines::SetMaps(const std::string& role, std::optional<show::Device> device,
                                 const std::string& level, const std::vector<std::string>& maps) {
  const auto value = toml::Parse(text(), file_);
  if (!value) return tl::unexpected(value.error());
  const auto roles = TablesOf(*value, "role");
  const auto found = std::ranges::find_if(
      roles, [&](const toml::Value* one) { return IsText(toml::Find(*one, "name"), role); });
  if (found == roles.end() && maps.empty()) return {};
  if (found == roles.end()) {
    std::string table = fmt::format("[[role]]\nname = {}", toml::Quoted(role));
    if (device)
      table += fmt::format("\ndevice = \"{}\"", show::kDeviceNames[static_cast<std::size_t>(*device)]);
    AddTable(table);
    AddMaps(lines_.size(), maps);
  } else {
    const auto span = SpanOf(**found, "[[role]]", Begins(*value));
    if (!span) return tl::unexpected(span.error());
    const auto removed = RemoveMaps(**found, level, span->end);
    if (!removed) return tl::unexpected(removed.error());
    AddMaps(span->end - *removed, maps);
  }
  *this = RolesLines(text(), file_);  // What was added has lines too.
  return {};
}

// From the last to the first, so that lines before keep their numbers.
Result<std::size_t> RolesLines::RemoveMaps(const toml::Value& role, const std::string& level,
                                           std::size_t end) {
  const auto maps = TablesOf(role, "map");
  std::vector<std::size_t> begins{end};
  for (const toml::Value* map : maps) begins.push_back(LineOf(*map));
  std::ranges::sort(begins);
  std::size_t removed = 0;
  for (auto map = maps.rbegin(); map != maps.rend(); ++map) {
    if (!IsText(toml::Find(**map, "level"), level)) continue;
    const auto span = SpanOf(**map, "[[role.map]]", begins);
    if (!span) return tl::unexpected(span.error());
    removed += Remove(*span);
  }
  return removed;
}

// The empty line before it goes as well.
std::size_t RolesLines::Remove(Span span) {
  while (SaysNothing(lines_[span.end - 1])) --span.end;
  if (span.first > 0 && Trimmed(lines_[span.first - 1]).empty()) --span.first;
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(span.first),
               lines_.begin() + static_cast<std::ptrdiff_t>(span.end));
  return span.end - span.first;
}

// Behind the last line of the role that says something: a comment that follows is of the next table.
void RolesLines::AddMaps(std::size_t end, const std::vector<std::string>& maps) {
  while (end > 0 && SaysNothing(lines_[end - 1])) --end;
  std::vector<std::string> added;
  for (const std::string& map : maps) {
    added.emplace_back();
    added.push_back(map.substr(0, map.find_last_not_of('\n') + 1));
  }
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(end), added.begin(), added.end());
}

Result<void> RolesLines::SetButton(std::uint8_t button, const std::string& call) {
  const auto value = toml::Parse(text(), file_);
  if (!value) return tl::unexpected(value.error());
  const auto begins = Begins(*value);
  const NamedButton named = NameOfButton(button);
  const std::string_view device = show::kDeviceNames[static_cast<std::size_t>(named.device)];
  const bool is_box = named.device == show::Device::kDialBox;
  for (const toml::Value* table : TablesOf(*value, "button")) {
    const toml::Value* const number = toml::Find(*table, "number");
    const toml::Value* const of = toml::Find(*table, "device");
    if (number == nullptr || number->number != named.number) continue;
    if (of == nullptr ? !is_box : !IsText(of, device)) continue;
    const auto span = SpanOf(*table, "[[button]]", begins);
    if (!span) return tl::unexpected(span.error());
    Remove(*span);
    break;
  }
  AddTable(fmt::format("[[button]]\n{}number = {}\ncall = {}",
                       is_box ? std::string() : fmt::format("device = \"{}\"\n", device), named.number,
                       toml::Quoted(call)));
  *this = RolesLines(text(), file_);
  return {};
}

void RolesLines::AddTable(const std::string& table) {
  if (!lines_.empty() && !Trimmed(lines_.back()).empty()) lines_.emplace_back();
  lines_.push_back(table);
}

}  // namespace kaori::roles
