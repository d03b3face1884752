// The options of a program: "--name VALUE" and "--switch". A wrong one is named in one line on standard
// error.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kaori {

// Declares a program's options and reads them once. The variables are the caller's own and carry the
// defaults, so that nothing has to be asked for by name later. One thread.
class Options {
 public:
  // `help` is the page that --help prints. All that is passed by reference must outlive Parse.
  explicit Options(std::string_view help) : help_(help) {}

  // Declares an option with a value, which stays as it is where the option is not given; `needed`: it must
  // not be empty after Parse.
  Options& Text(std::string_view name, std::string& value, bool needed = false);
  // Declares an option without a value; it sets `value` to true.
  Options& Switch(std::string_view name, bool& value);

  // Sets the values, from left to right: of an option that is given twice the last value counts.
  // Returns the exit status when the program is to end: 0 after --help, 2 after an unknown option,
  // one without its value, or one that is needed and missing. Values are texts; what they mean is
  // for the caller to check. "--name=VALUE" is not understood.
  std::optional<int> Parse(int argc, char** argv);

  // Exactly one of `text` and `flag` is set; it tells the two kinds of option apart.
 private:
  struct Option {
    std::string_view name;
    std::string* text;
    bool* flag;
    bool needed;
  };
  // Null where no option of this name was declared.
  const Option* Find(std::string_view name) const;

  std::string_view help_;
  std::vector<Option> options_;
};

// "960x540" as width and height; nothing for anything else, or a side outside 16..16384. Smaller
// pictures show nothing, larger ones no graphics card scans out.
struct Size {
  int width_px = 0;
  int height_px = 0;
};
std::optional<Size> ParseSize(const std::string& text);

}  // namespace kaori
