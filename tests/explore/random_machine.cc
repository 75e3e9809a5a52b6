#include "random_machine.h"

#include <fmt/core.h>

namespace oncard::explore {

RandomMachine::RandomMachine(uint64_t seed, bool counts)
    : random_(seed), counts_(counts), threads_(2 + Draw(2)) {
  source_ = counts ? "int g[4];\nint sum;\n" : "int g[4];\n";
  for (int thread = 0; thread < threads_; ++thread) AddThread(thread);
  AddKeys();
}

void RandomMachine::AddThread(int thread) {
  source_ += fmt::format("int t{}() {{\n  int n;\n  int time;\n  double p;\n", thread);
  const int count = 2 + Draw(4);
  for (int i = 0; i < count; ++i) {
    AddStatement(thread, i);
    if (counts_ && Draw(2) == 0) AddCount(i);
  }
  source_ += fmt::format("  return {};\n}}\n", Draw(2));
}

void RandomMachine::AddStatement(int thread, int number) {
  const int own = ThingOf(thread);
  const int bit = 1 << own;
  switch (Draw(9)) {
    case 0:
      source_ += fmt::format("  g[{}] = {};\n", own, Draw(3));
      break;
    case 1:
      source_ += fmt::format("  n = g[{0}];\n  g[{0}] = n + 1;\n", own);
      break;
    case 2:
      source_ += fmt::format("  GT_SetDoBit(12, {}, {});\n", own + 1, Draw(2));
      break;
    case 3:
      source_ += fmt::format("  GT_Delay({});\n", 1 + Draw(2));
      break;
    case 4:
    case 5:
      source_ += fmt::format("  GT_PrfJog({0});\n  GT_SetVel({0}, {1});\n  GT_Update({2});\n",
                             own + 1, 1 + Draw(20), bit);
      break;
    case 6:
      source_ += fmt::format("  GT_Stop({}, {});\n", bit, Draw(2) * bit);
      break;
    case 7:
      source_ += fmt::format(
          "L{0}:\n  GT_GetPrfPos({1}, &p, 1, &time);\n  n = p > {2};\n  if (n) goto E{0};\n  "
          "GT_GetSts({1}, &n, 1, &time);\n"
          "  n = n & 1024;\n  if (n) goto L{0};\nE{0}:\n",
          number, own + 1, Draw(3));
      break;
    default:
      source_ += fmt::format("  GT_GetDi(4, &n);\n  n = n & 1;\n  g[{}] = n;\n", own);
      break;
  }
}

/// Always, or depending on what the thread has found last.
void RandomMachine::AddCount(int number) {
  if (Draw(2) == 0) {
    source_ += fmt::format("  sum = sum + {};\n", 1 + Draw(3));
  } else {
    source_ += fmt::format("  if (n) goto S{0};\n  sum = sum - {1};\nS{0}:\n", number, 1 + Draw(2));
  }
}

std::string RandomMachine::Condition() {
  const int of = Draw(threads_);
  switch (Draw(9)) {
    case 0:
      return fmt::format("g[{}] < {}", of, 1 + Draw(4));
    case 1:
      return fmt::format("axis{}.prfPos < {}", of + 1, 1 + Draw(8));
    case 2:
      return fmt::format("axis{}.moving == 0", of + 1);
    case 3:
      return fmt::format("gpo[{}] == {}", of + 1, Draw(2));
    case 4:
      return fmt::format("clock < {}", 2 + Draw(4));
    case 5:
      return fmt::format("ret{} == {}", of, Draw(2));
    case 6:
      return fmt::format("page{}.n < {}", of, 1 + Draw(3));
    case 7:
      return fmt::format("(g[{}] == {} || clock < {})", of, Draw(3), 1 + Draw(3));
    default:
      return fmt::format("(axis{}.prfVel < {} || g[{}] > 0)", of + 1, 1 + Draw(9),
                         Draw(10) == 0 ? Draw(threads_) : of);
  }
}

void RandomMachine::AddKeys() {
  keys_ = fmt::format("rate = {}\n", 12 + 4 * Draw(3));
  keys_ += Draw(3) == 0 ? fmt::format("until_ms = {}\n", 3 + Draw(2)) : "limit_ms = 8\n";
  if (Draw(4) == 0) keys_ += "races = \"none\"\n";
  const int first = Draw(6);
  for (int kind = first; kind < first + 2; ++kind) {
    switch (kind % 6) {
      case 0:
        if (counts_) break;
        keys_ += fmt::format("final = [\"{} && {}\"]\n", Condition(), Condition());
        break;
      case 1:
        keys_ += fmt::format("always = [\"{}\"]\n", Condition());
        break;
      case 2:
        keys_ += fmt::format("never = [\"!{}\"]\n", "(" + Condition() + ")");
        break;
      case 3:
        keys_ += fmt::format("eventually = [\"{}\"]\n", Condition());
        break;
      case 4:
        keys_ +=
            fmt::format("within = [{{ after = \"gpo[{0}] == 0\", then = \"{1}\", ms = {2} }}]\n",
                        1 + Draw(threads_), Condition(), Draw(3));
        break;
      default:
        keys_ +=
            fmt::format("expect = [\"{} && {} @ {}ms\"]\n", Condition(), Condition(), 1 + Draw(2));
        break;
    }
  }
  if (counts_) {
    keys_ += fmt::format("final = [\"sum {} {}\"]\n", Draw(3) == 0 ? "!=" : "<", Draw(12) - 2);
  }
  if (Draw(2) == 0) {
    keys_ += "[[world.input]]\nat_ms = 0.5\ntype = \"gpi\"\nindex = 1\nvalue = 1\n";
  }
}

}  // namespace oncard::explore
