// Places in files, and errors that show them: `path:line:column: what`, the line, and a caret.
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

/// The text around a text that is only a part of its file.
struct TextMargin {
  int lines = 0;    ///< before its first line
  int columns = 0;  ///< before each line
};

/// The text of a file, for errors with places in it.
class TextFile {
 public:
  TextFile(std::string path, std::string_view text, TextMargin margin = {});

  const std::string& path() const { return path_; }
  const TextMargin& margin() const { return margin_; }
  /// A line, counted from 1, without its end; empty if there is none.
  std::string_view Line(int number) const;

 private:
  std::string path_;
  std::string text_;
  TextMargin margin_;
  std::vector<size_t> begins_;  ///< of the lines
};

/// A place in a file.
struct TextPlace {
  std::shared_ptr<const TextFile> file = nullptr;  ///< NULL: no file, as for a command line
  int line = 0;                                    ///< of the text, from 1; 0: the whole file
  int column = 0;                                  ///< from 1
  size_t begin = 0;                                ///< bytes of the line, for the caret
  size_t end = 0;

  /// `path:line:column: `, counted as in the file; empty without a file.
  std::string Headline() const;
  /// A line end, the line, and a caret below it. Empty without a file, for a whole file, and for a
  /// line of more than kExcerptMax bytes.
  std::string Excerpt() const;

  static constexpr size_t kExcerptMax = 400;

  /// The place is not part of the value, so comparison ignores it.
  bool operator==(const TextPlace&) const { return true; }
};

/// Errors in several places, to be reported together.
class PlacedErrors {
 public:
  /// Maximum number of errors shown for one input; further ones are only counted.
  static constexpr size_t kShown = 20;

  void Add(TextPlace place, Message message);
  bool empty() const { return errors_.empty(); }
  /// All errors, ordered by file name and place, those without a place last; the code is 1. Empty
  /// if there are none.
  std::optional<Error> Failure() const;

 private:
  struct PlacedError {
    TextPlace place;
    Message message;
  };

  std::vector<PlacedError> errors_;
};

}  // namespace oncard::runtime
