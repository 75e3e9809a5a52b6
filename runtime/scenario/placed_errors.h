// Places in files, and errors that name them: `path:line:column: what`, the line, and a caret.
// Plain values, safe to read from several threads.
// Tested by tests/runtime/placed_errors_test.cc.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/result.h"

namespace oncard::runtime {

/// The text of a file that was read, for those that speak of places in it.
class TextFile {
 public:
  TextFile(std::string path, std::string_view text);

  const std::string& path() const { return path_; }
  /// A line, counted from 1, without its end; empty where there is none.
  std::string_view Line(int number) const;

 private:
  std::string path_;
  std::string text_;
  std::vector<size_t> begins_;  ///< of the lines
};

/// Where something stands in a file.
struct TextPlace {
  std::shared_ptr<const TextFile> file = nullptr;  ///< NULL: nowhere, as on a command line
  int line = 0;                                    ///< from 1; 0: it is the whole file
  int column = 0;                                  ///< from 1
  size_t begin = 0;                                ///< bytes of the line, for the caret
  size_t end = 0;

  /// `path:line:column: `; empty for nowhere.
  std::string Headline() const;
  /// A line end, the line, and a caret below. Empty for nowhere, for a whole file, and for a line
  /// of more than kExcerptMax bytes.
  std::string Excerpt() const;

  static constexpr size_t kExcerptMax = 400;

  /// Where it stands is no part of what is said: what has a place compares as if it had none.
  bool operator==(const TextPlace&) const { return true; }
};

/// What is wrong in several places, to be told at once.
class PlacedErrors {
 public:
  /// Of one input, so many are shown; the others are counted.
  static constexpr size_t kShown = 20;

  void Add(TextPlace place, Message message);
  bool empty() const { return errors_.empty(); }
  /// All errors in the order of their files' names and their places, those from nowhere last; the
  /// code is 1. Empty without one.
  std::optional<Error> Failure() const;

 private:
  struct PlacedError {
    TextPlace place;
    Message message;
  };

  std::vector<PlacedError> errors_;
};

}  // namespace oncard::runtime
