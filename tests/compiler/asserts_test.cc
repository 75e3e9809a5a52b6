// Which statement an assert stands before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/compiler.h"
#include "tests/compiler/memory_files.h"

namespace oncard::compiler {
namespace {

using testing::ElementsAre;

vm::Assert At(uint16_t position, std::string condition) { return {position, std::move(condition)}; }

vm::Object Compiled(const std::string& source) {
  const Compilation compilation = CompileText("p.c", source, {}, NoFiles());
  EXPECT_TRUE(compilation.ok()) << compilation.diagnostics.front().message.en;
  return compilation.object.value_or(vm::Object());
}

TEST(AssertsTest, BelongToTheNextStatement) {
  const vm::Object object = Compiled(
      "int x;\n"
      "int t0() {\n"
      "  int c;\n"
      "  //@ assert: x < 1\n"
      "  x = 1; x = 2;\n"
      "  // A remark.\n"
      "  //@ assert:x<2\n"
      "\n"
      "  //@assert : c == 0 || x < 3\n"
      "again:\n"
      "  /* another */\n"
      "  c = x > 3;\n"
      "  //@ assert: x < 4\n"
      "  if (c) goto again;\n"
      "  return 0;\n"
      "}\n"
      "int t1() {\n"
      "again:\n"
      "  //@ assert: x < 5\n"
      "  return x;\n"
      "}\n");
  ASSERT_EQ(object.functions.size(), 2u);
  EXPECT_THAT(object.functions[0].asserts,
              ElementsAre(At(0, "x < 1"), At(2, "x<2"), At(2, "c == 0 || x < 3"), At(3, "x < 4")));
  EXPECT_THAT(object.functions[1].asserts, ElementsAre(At(0, "x < 5")));
}

TEST(AssertsTest, DoNotChangeTheProgram) {
  vm::Object with = Compiled("int x;\nint t0() {\n//@ assert: x < 1\nx = 1;\nreturn x;\n}\n");
  const vm::Object without = Compiled("int x;\nint t0() {\n\nx = 1;\nreturn x;\n}\n");
  EXPECT_NE(with, without);
  with.functions[0].asserts.clear();
  EXPECT_EQ(with, without);
}

}  // namespace
}  // namespace oncard::compiler
