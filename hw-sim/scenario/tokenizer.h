// A line of a scenario as words that know their columns, and what was wrong with it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::sim {

// What is wrong in a text, and where.
struct Problem {
  int line = 0;    // From 1.
  int column = 0;  // In characters, from 1.
  // A sentence for people, without line and column.
  std::string what;
};

// A word of a line; it points into the line.
struct Token {
  std::string_view text;  // Without its quotes.
  // Of its first letter, or of its quote.
  int column = 0;
};

// Reads the words of one line; a comment begins with #, quotes hold spaces. After the first problem of a
// line every question gets no answer, so that a line complains once. A reader need not check each answer
// for that reason: it asks on, and `bad` tells in the end. One line, one tokenizer.
class Tokenizer {
 public:
  // Splits the line into words. Borrows the line and the problems, which must outlive
  // it. `number` is the line's, from 1.
  Tokenizer(std::string_view line, int number, std::vector<Problem>& problems);

  // No more words, or no more use in asking.
  bool AtEnd() const { return bad_ || next_ >= tokens_.size(); }
  // The line has a problem; nothing more can be read of it.
  bool bad() const { return bad_; }
  // Whether the next word is `word`; goes on to the one behind it if so.
  bool Accept(std::string_view word);

  // Whether the next word begins as a number does.
  bool NumberFollows() const;

  // The next word; nothing at the line's end, which is a problem then. `expected` says what
  // should be there: "a number of turns".
  std::optional<Token> Next(std::string_view expected);
  // A decimal number from `low` to `high`, both included; anything else is a problem.
  std::optional<double> Number(std::string_view expected, double low, double high);
  // The number of a thing, from 1 to `last`; else the problem is such as "no dial 9; dials are 1 to 8".
  std::optional<int> Numbered(std::string_view thing, int last);
  // 2.5s or 800ms, from 0 to 24 hours, rounded to nanoseconds; anything else is a problem.
  std::optional<Duration> TimeSpan();

  // Adds a problem of this line, unless it has one: the first is the cause of the others.
  void Complain(int column, std::string what);
  int last_column() const { return last_column_; }  // Of the word that was read last.
  int next_column() const;                          // Of the word to come, or of the line's end.

 private:
  // Fills tokens_, or complains.
  void Split(std::string_view line);

  std::vector<Token> tokens_;
  // Index of the next word.
  std::size_t next_ = 0;
  int number_;
  // Behind the last word.
  int end_column_ = 1;
  int last_column_ = 1;
  bool bad_ = false;
  std::vector<Problem>& problems_;
};

}  // namespace kaori::sim
