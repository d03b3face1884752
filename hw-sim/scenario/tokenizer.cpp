#include "hw-sim/scenario/tokenizer.h"

#include <cmath>

#include <fmt/format.h>

#include "drivers/base/number.h"

namespace kaori::sim {
namespace {

// A day: longer times are slips of the keyboard.
constexpr double kLongestTime_s = 24 * 60 * 60;
// Nobody writes more, and looking for columns takes time with the square of the length.
constexpr std::size_t kLongestLine_bytes = 1000;

// Columns count characters: a byte of the form 10xxxxxx goes on with the one before it.
int ColumnAt(std::string_view line, std::size_t byte) {
  int column = 1;
  for (const char c : line.substr(0, byte)) column += (static_cast<unsigned char>(c) & 0xC0) == 0x80 ? 0 : 1;
  return column;
}

// A carriage return too, so that files with lines of Windows are read.
bool IsSpace(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// The whole text as a number; a sign before it is free. Infinities are none.
// Independent of the locale, as strtod is not.
std::optional<double> WholeNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto value = ParseNumber<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

Tokenizer::Tokenizer(std::string_view line, int number, std::vector<Problem>& problems)
    : number_(number), problems_(problems) {
  Split(line);
}

// A word ends at a space or at a comment; one in quotes at the next quote.
void Tokenizer::Split(std::string_view line) {
  if (line.size() > kLongestLine_bytes) return Complain(1, "a line of more than 1000 bytes");
  std::size_t at = 0;
  while (at < line.size()) {
    if (IsSpace(line[at])) {
      ++at;
      continue;
    }
    if (line[at] == '#') break;
    const int column = ColumnAt(line, at);
    const bool quoted = line[at] == '"';
    std::size_t end = at + 1;
    while (end < line.size() && (quoted ? line[end] != '"' : !IsSpace(line[end]) && line[end] != '#')) ++end;
    if (quoted && end == line.size()) return Complain(column, "a quote that nothing closes");
    const std::size_t quote = line.substr(0, end).find('"', at + 1);
    if (!quoted && quote != line.npos)
      return Complain(ColumnAt(line, quote), "a quote within a word; put the whole word into quotes");
    tokens_.push_back({quoted ? line.substr(at + 1, end - at - 1) : line.substr(at, end - at), column});
    at = quoted ? end + 1 : end;
    end_column_ = ColumnAt(line, at);
  }
}

int Tokenizer::next_column() const {
  return next_ < tokens_.size() ? tokens_[next_].column : end_column_;
}

bool Tokenizer::Accept(std::string_view token) {
  if (AtEnd() || tokens_[next_].text != token) return false;
  last_column_ = tokens_[next_++].column;
  return true;
}

// A sign counts: "press pointer -1" is then a bad number, and no other word.
bool Tokenizer::NumberFollows() const {
  if (AtEnd()) return false;
  const char first = tokens_[next_].text.empty() ? ' ' : tokens_[next_].text.front();
  return (first >= '0' && first <= '9') || first == '-' || first == '+';
}

std::optional<Token> Tokenizer::Next(std::string_view expected) {
  if (bad_) return std::nullopt;
  if (AtEnd()) {
    Complain(end_column_, fmt::format("the line ends where {} is expected", expected));
    return std::nullopt;
  }
  last_column_ = tokens_[next_].column;
  return tokens_[next_++];
}

std::optional<double> Tokenizer::Number(std::string_view expected, double low, double high) {
  const auto token = Next(expected);
  if (!token) return std::nullopt;
  const auto value = WholeNumber(token->text);
  if (value && *value >= low && *value <= high) return value;
  Complain(token->column, fmt::format("\"{}\" is not {} ({} to {})", token->text, expected, low, high));
  return std::nullopt;
}

// From 1, as people count; whoever asks takes 1 off.
std::optional<int> Tokenizer::Numbered(std::string_view thing, int last) {
  const auto token = Next(fmt::format("the number of a {}", thing));
  if (!token) return std::nullopt;
  const auto value = ParseNumber<int>(token->text);
  if (value && *value >= 1 && *value <= last) return value;
  Complain(token->column, fmt::format("no {0} {1}; {0}s are 1 to {2}", thing, token->text, last));
  return std::nullopt;
}

// A time without a unit is refused, since nobody could tell what was meant.
std::optional<Duration> Tokenizer::TimeSpan() {
  const auto token = Next("a time such as 2.5s or 800ms");
  if (!token) return std::nullopt;
  std::string_view text = token->text;
  const bool milli = text.ends_with("ms");
  if (milli || text.ends_with('s')) {
    text.remove_suffix(milli ? 2 : 1);
    const auto value = WholeNumber(text);
    const double seconds = value ? *value * (milli ? 1e-3 : 1.0) : -1;
    if (seconds >= 0 && seconds <= kLongestTime_s)
      return Duration(static_cast<Duration::rep>(std::llround(seconds * 1e9)));
  }
  Complain(token->column,
           fmt::format("\"{}\" is no time; times are such as 2.5s or 800ms, up to 24 hours", token->text));
  return std::nullopt;
}

void Tokenizer::Complain(int column, std::string what) {
  if (bad_) return;
  bad_ = true;
  problems_.push_back({number_, column, std::move(what)});
}

}  // namespace kaori::sim
