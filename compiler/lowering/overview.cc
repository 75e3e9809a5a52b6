#include "compiler/lowering/overview.h"

namespace oncard::compiler {
namespace {

constexpr std::string_view kEnglishPage = R"(structured C

The card's language has one operation per statement, and goto. Structured C is
C as people write it, and `oncard lower FILE.c -o OUT.c` translates it:

  for, while, do, if, else, switch, break, continue, goto
  nested expressions, ?:, && and ||, =, +=, ++ and the comma as in C
  functions of your own with values, arrays and references (int *p) as
  parameters; recursive ones with their depth, //@ depth: N
  int, unsigned, short, char, bool, double with C's conversions; enum, const,
  struct, typedef
  arrays with several dimensions, initial values, static locals
  macros with parameters, #if, included files

    int sum;                          int sum;
                                      void t0(int n) {
    void t0(int n) {                    int tmp1;
      while (n > 0) sum += n--;       lbl_while_4:
    }                                   tmp1 = n <= 0;
                                        if (tmp1) goto lbl_while_4_end;
                                        ...

Functions that no other function calls are thread functions. They, their
parameters and the globals keep their names. Functions that are called are
inserted where they are called, or stand once and are jumped to where that is
shorter.

Another thread can run between two statements of the card. --annotate marks the
statements of C that read and write a global in different ones.

Pointers that are variables, strings, 64-bit integers and unions are refused,
with the reason and the line, and no output is written.

docs/structured.md shows every construct with what it becomes.
)";

constexpr std::string_view kChinesePage = R"(结构化 C

控制卡的语言每条语句只有一个操作，用 goto 跳转。结构化 C 是通常写法的 C，由
`oncard lower FILE.c -o OUT.c` 转换：

  for、while、do、if、else、switch、break、continue、goto
  嵌套表达式、?:、&& 和 ||、=、+=、++ 和逗号，含义与 C 相同
  自己的函数，参数为值、数组或引用（int *p）；递归函数须写深度 //@ depth: N
  int、unsigned、short、char、bool、double 及 C 的转换；enum、const、struct、
  typedef
  多维数组、初值、static 局部变量
  带参数的宏、#if、包含文件

    int sum;                          int sum;
                                      void t0(int n) {
    void t0(int n) {                    int tmp1;
      while (n > 0) sum += n--;       lbl_while_4:
    }                                   tmp1 = n <= 0;
                                        if (tmp1) goto lbl_while_4_end;
                                        ...

没有被其他函数调用的函数是线程函数。线程函数及其参数、全局变量的名称不变。
被调用的函数插入到调用处；如果更短，则只出现一次，用跳转调用。

控制卡的两条语句之间可能运行其他线程。--annotate 标出在不同语句中读写同一
全局变量的 C 语句。

指针变量、字符串、64 位整数和联合会被拒绝，给出原因和行号，不写输出。

docs/structured.zh-CN.md 列出每种结构及其转换结果。
)";

}  // namespace

std::string_view StructuredOverview(Language language) {
  return language == Language::kChinese ? kChinesePage : kEnglishPage;
}

}  // namespace oncard::compiler
