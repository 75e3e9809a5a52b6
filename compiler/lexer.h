// Splits a file into tokens. Tested by tests/compiler/literal_test.cc and tests/lang/lexical.
#pragma once

#include <vector>

#include "compiler/dialect.h"
#include "compiler/reporter.h"
#include "compiler/syntax.h"
#include "gtcalls/catalogue.h"

namespace oncard::compiler {

/// The tokens of a file, without an end token. Comments and white space are skipped; malformed
/// numbers and illegal characters are reported and leave a token that the parser skips without a
/// further report. Scanning stops after `token_max` tokens. The file's text must outlive the
/// tokens; the catalogue has the structures that programs may declare. Structured C has more
/// keywords and constants: enum, sizeof, bool, binary and octal numbers, characters.
std::vector<Token> Tokenize(const SourceFile& file, int file_index, size_t token_max,
                            const gtcalls::Catalogue& catalogue, Reporter& reporter,
                            Dialect dialect = Dialect::kCard);

/// Whether a token is a name or a keyword.
bool IsWord(const Token& token);

/// The name of a token in messages: 'x', or a description if it has no text.
Message DescribeToken(const Token& token);

}  // namespace oncard::compiler
