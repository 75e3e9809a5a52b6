// The table of opcodes in docs/object-format.md is the one generated from vm/opcodes.def.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace oncard::vm {
namespace {

using testing::HasSubstr;

std::string ReadAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(OpcodeTablesTest, ObjectFormatDocumentIsUpToDate) {
  const std::string generated = ReadAll(ONCARD_GENERATED_OBJECT_FORMAT);
  ASSERT_FALSE(generated.empty());
  EXPECT_TRUE(ReadAll(ONCARD_SOURCE_DIR "/docs/object-format.md") == generated)
      << "run `cmake --build . --target update_opcode_tables`";
}

// Numbers, types and basis of two rows, as a check that does not depend on the generator.
TEST(OpcodeTablesTest, RowsSayWhatTheTableOfOpcodesSays) {
  const std::string document = ReadAll(ONCARD_SOURCE_DIR "/docs/object-format.md");
  EXPECT_THAT(document, HasSubstr("\n| 0x5080 | jump | cond rel | | "));
  EXPECT_THAT(document, HasSubstr("\n| binary 0x0B | `>` | int or double | int | "));
  EXPECT_THAT(document, HasSubstr("\n| binary 0x0F | `\\|` | int | int | bitwise or | A |\n"));
}

}  // namespace
}  // namespace oncard::vm
