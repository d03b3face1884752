#include "drivers/base/json.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace kaori::json {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD in UTF-8.

// How many bytes at the beginning of `text` are one character of UTF-8 (Unicode 15, table 3-7); 0: they are
// none, and `wrong` tells how many of them to pass over.
std::size_t CharacterBytes(std::string_view text, std::size_t& wrong) {
  const auto byte = [text](std::size_t n) { return static_cast<unsigned char>(text[n]); };
  const unsigned char first = byte(0);
  wrong = 1;
  if (first < 0x80) return 1;
  const std::size_t count = first >= 0xC2 && first <= 0xDF   ? 2
                            : (first & 0xF0U) == 0xE0        ? 3
                            : first >= 0xF0 && first <= 0xF4 ? 4
                                                             : 0;
  for (std::size_t n = 1; n < count; ++n) {
    // The second byte bounds the number from below (no longer form than needed), and away from surrogates and
    // beyond U+10FFFF.
    const unsigned char low = n > 1 ? 0x80 : first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const unsigned char high = n > 1 ? 0xBF : first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    if (n >= text.size() || byte(n) < low || byte(n) > high) return 0;
    ++wrong;
  }
  return count;
}

// Appends to one text. Depth is counted in open brackets; it decides how far a line is indented.
class Writer {
 public:
  explicit Writer(int indent) : indent_(indent) {}

  std::string Write(const Value& value) {
    Add(value);
    return std::move(text_);
  }

 private:
  void Add(const Value& value) {
    if (const auto* on = value.As<bool>())
      text_ += *on ? "true" : "false";
    else if (const auto* whole = value.As<std::int64_t>())
      fmt::format_to(std::back_inserter(text_), "{}", *whole);
    else if (const auto* number = value.As<double>())
      AddNumber(*number);
    else if (const auto* text = value.As<std::string>())
      AddText(*text);
    else if (const auto* list = value.As<List>())
      AddList(*list);
    else if (const auto* object = value.As<Object>())
      AddObject(*object);
    else
      text_ += "null";
  }

  void AddNumber(double number) {
    if (!std::isfinite(number)) {
      text_ += "null";
      return;
    }
    const std::size_t begin = text_.size();
    fmt::format_to(std::back_inserter(text_), "{}", number);
    // fmt prints 3.0 as "3", which readers with types take for an integer.
    // An exponent ("1e+30") marks a double already.
    if (text_.find_first_of(".e", begin) == std::string::npos) text_ += ".0";
  }

  void AddText(std::string_view text) {
    text_ += '"';
    while (!text.empty()) {
      std::size_t wrong = 0;
      const std::size_t bytes = CharacterBytes(text, wrong);
      if (bytes == 1)
        AddCharacter(text[0]);
      else
        text_ += bytes == 0 ? kReplacement : text.substr(0, bytes);
      text.remove_prefix(bytes == 0 ? wrong : bytes);
    }
    text_ += '"';
  }

  void AddCharacter(char c) {
    // The two lists go in step: the character at one place of kPlain is
    // written as a backslash and that of kEscaped.
    constexpr std::string_view kPlain = "\"\\\b\f\n\r\t", kEscaped = "\"\\bfnrt";
    if (const auto at = kPlain.find(c); at != std::string_view::npos) text_.append({'\\', kEscaped[at]});
    // RFC 8259, 7: control characters must be escaped; the rest may stand as it is.
    else if (static_cast<unsigned char>(c) < 0x20)
      fmt::format_to(std::back_inserter(text_), "\\u{:04x}", static_cast<unsigned>(c));
    else
      text_ += c;
  }

  void AddList(const List& list) {
    Open('[');
    for (const Value& value : list) {
      Separate(&value == &list.front());
      Add(value);
    }
    Close(']', list.empty());
  }

  void AddObject(const Object& object) {
    Open('{');
    for (const auto& [name, value] : object) {
      // An entry is known to be the first by its address: equal
      // entries would be mixed up by their values.
      Separate(&value == &object.front().second);
      AddText(name);
      text_ += indent_ > 0 ? ": " : ":";
      Add(value);
    }
    Close('}', object.empty());
  }

  void Open(char bracket) {
    text_ += bracket;
    ++depth_;
  }
  void Separate(bool first) {
    if (!first) text_ += ',';
    BreakLine();
  }
  void Close(char bracket, bool empty) {
    --depth_;
    if (!empty) BreakLine();
    text_ += bracket;
  }
  void BreakLine() {
    if (indent_ > 0)
      text_.append(1, '\n').append(static_cast<std::size_t>(indent_) * static_cast<std::size_t>(depth_), ' ');
  }

  int indent_;
  int depth_ = 0;
  std::string text_;
};

}  // namespace

std::string Write(const Value& value, int indent) {
  return Writer(indent).Write(value);
}

}  // namespace kaori::json
