// The files of a program while they are read, and how much may be read of them in all. Both
// dialects share them; what a directive means is directives.h for the card's language and
// preprocessor.h for structured C.
// Tested by tests/compiler/limits_test.cc and preprocessor_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/dialect.h"
#include "compiler/reporter.h"
#include "compiler/syntax.h"

namespace oncard::compiler {

class ProgramFiles {
 public:
  /// The references must outlive this object.
  ProgramFiles(const Options& options, const TextLimits& limits, Reporter& reporter,
               Dialect dialect)
      : options_(options), limits_(limits), reporter_(reporter), dialect_(dialect) {}

  /// Adds a file that the program includes at an offset, directly or not; the program is the first.
  /// Its tokens, or nothing if the program is refused because it would become too large.
  std::optional<std::vector<Token>> Add(SourceFile file, uint32_t inclusion_point);
  /// Reports at the file read last that the program is too large.
  void Refuse(const Message& why);
  /// Refuses a program about which the reason has been reported.
  void Stop() { refused_ = true; }
  /// Whether the program was refused: its tokens are not complete.
  bool refused() const { return refused_; }

  /// The token after the last one of the program.
  Token EndToken() const;

  /// Of the files read, which are numbered; the program is 0.
  int count() const { return static_cast<int>(files_.size()); }
  std::string_view TextOf(int file) const { return files_[static_cast<size_t>(file)].text(); }
  const std::string& PathOf(int file) const { return files_[static_cast<size_t>(file)].path(); }
  std::deque<SourceFile>& files() { return files_; }
  std::vector<uint32_t>& inclusion_points() { return inclusion_points_; }

 private:
  const Options& options_;
  const TextLimits limits_;
  Reporter& reporter_;
  const Dialect dialect_;
  std::deque<SourceFile> files_;
  std::vector<uint32_t> inclusion_points_;
  size_t read_bytes_ = 0;
  size_t scanned_tokens_ = 0;
  bool refused_ = false;
};

}  // namespace oncard::compiler
