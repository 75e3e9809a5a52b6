// Writes a document with its tables of keys made anew: update_key_tables docs/scenarios.md
#include <fmt/core.h>

#include "base/files.h"
#include "runtime/scenario/file/key_document.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: update_key_tables DOCUMENT\n");
    return 2;
  }
  auto document = oncard::ReadFile(argv[1]);
  if (document.ok()) document = oncard::runtime::UpdateKeyTables(std::move(document).value());
  const auto written = document.ok() ? oncard::WriteFileAtomically(argv[1], document.value())
                                     : oncard::Result<void>(document.error());
  if (written.ok()) return 0;
  fmt::print(stderr, "update_key_tables: {}\n", written.error().message.en);
  return 1;
}
