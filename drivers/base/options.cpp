#include "drivers/base/options.h"

#include <algorithm>
#include <cstdio>
#include <span>

#include <fmt/format.h>

namespace kaori {
namespace {

std::optional<int> Misused(std::string_view what, std::string_view name) {
  fmt::print(stderr, "{} {}; --help tells the rest\n", what, name);
  // Two is what shells and getopt programs return for misuse; one is left to failures of the work itself.
  return 2;
}

}  // namespace

Options& Options::Text(std::string_view name, std::string& value, bool needed) {
  options_.push_back({name, &value, nullptr, needed});
  return *this;
}

Options& Options::Switch(std::string_view name, bool& value) {
  options_.push_back({name, nullptr, &value, false});
  return *this;
}

const Options::Option* Options::Find(std::string_view name) const {
  const auto it = std::ranges::find(options_, name, &Option::name);
  return it == options_.end() ? nullptr : &*it;
}

std::optional<int> Options::Parse(int argc, char** argv) {
  const std::span<char*> args(argv, static_cast<std::size_t>(argc));
  for (std::size_t i = 1; i < args.size(); ++i) {
    const std::string_view name = args[i];
    if (name == "--help" || name == "-h") {
      fmt::print("{}", help_);
      return 0;
    }
    const Option* option = Find(name);
    if (option == nullptr) return Misused("there is no option", name);
    if (option->flag != nullptr) {
      // A value may begin with a dash: whatever follows an option is its value.
      *option->flag = true;
    } else if (i + 1 < args.size()) {
      *option->text = args[++i];
    } else {
      return Misused("a value is missing after", name);
    }
  }
  for (const Option& option : options_)
    if (option.needed && option.text->empty()) return Misused("this option is needed:", option.name);
  return std::nullopt;
}

// Five digits a side, so that no number overflows before it is compared.
std::optional<Size> ParseSize(const std::string& text) {
  constexpr int kSmallest = 16, kLargest = 16384;
  Size size;
  // It takes a character behind the numbers, so that "960x540p" gives three matches and is refused.
  char rest = 0;
  if (std::sscanf(text.c_str(), "%5dx%5d%c", &size.width_px, &size.height_px, &rest) != 2)
    return std::nullopt;
  const auto fits = [](int side) { return side >= kSmallest && side <= kLargest; };
  if (!fits(size.width_px) || !fits(size.height_px)) return std::nullopt;
  return size;
}

}  // namespace kaori
