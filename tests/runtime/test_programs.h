// Motion programs for the runtime's tests.
#pragma once

#include <string_view>

namespace oncard::runtime {

/// GTS manual example 10-1: adds begin..end to the global sum.
inline constexpr std::string_view kSumProgram = R"(int sum;
int add(int begin, int end)
{
  int i;
  int cc;
  i = begin;
lbl_loop:
  cc = i > end;
  if (cc) goto lbl_end;
  sum = sum + i;
  i = i + 1;
  goto lbl_loop;
lbl_end:
  return sum;
}
)";

/// Counts statements in `count` forever: two statements per iteration.
inline constexpr std::string_view kEndlessProgram = R"(int count;
int run()
{
loop:
  count = count + 1;
  goto loop;
}
)";

}  // namespace oncard::runtime
