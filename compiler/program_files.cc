#include "compiler/program_files.h"

#include <utility>

#include "compiler/lexer.h"
#include "compiler/parser.hh"

namespace oncard::compiler {

std::optional<std::vector<Token>> ProgramFiles::Add(SourceFile file, uint32_t inclusion_point) {
  const int index = count();
  files_.push_back(std::move(file));
  inclusion_points_.push_back(inclusion_point);
  const size_t bytes = files_.back().text().size();
  if (bytes > limits_.bytes - read_bytes_) {
    Refuse(MakeMessage("the program and what it includes have more than {0} bytes",
                       "程序及其包含的文件超过 {0} 字节", limits_.bytes));
  }
  if (refused_) return std::nullopt;
  read_bytes_ += bytes;
  // One token more than the limit is read, to detect a program with too many.
  const size_t token_max = limits_.tokens - scanned_tokens_;
  std::vector<Token> tokens =
      Tokenize(files_.back(), index, token_max + 1, *options_.catalogue, reporter_, dialect_);
  if (tokens.size() > token_max) {
    Refuse(MakeMessage("the program has more than {0} tokens", "程序的记号超过 {0} 个",
                       limits_.tokens));
    return std::nullopt;
  }
  scanned_tokens_ += tokens.size();
  return tokens;
}

void ProgramFiles::Refuse(const Message& why) {
  if (refused_) return;
  refused_ = true;
  const SourceRange start = {count() - 1, 0, 0};
  reporter_.Report(Code::kCannotOpen, start, files_.back().path(), why);
}

Token ProgramFiles::EndToken() const {
  Token end;
  end.kind = Parser::token::kEnd;
  const uint32_t size = static_cast<uint32_t>(files_[0].text().size());
  end.range = {0, size, size};
  end.on_new_line = true;
  return end;
}

}  // namespace oncard::compiler
