#include "card_machines.h"

namespace oncard::explore {

const std::vector<CardMachine>& CardMachines() {
  static const std::vector<CardMachine> kMachines = {
      // An axis follows another one.
      {"Gear",
       "int t0() { GT_AxisOn(1); GT_PrfTrap(1); GT_SetVel(1, 5); GT_SetPos(1, 20);"
       " GT_Update(1); return 0; }\n"
       "int t1() { GT_AxisOn(2); GT_PrfGear(2, 0); GT_SetGearMaster(2, 1, 2, 0);"
       " GT_SetGearRatio(2, 1, 1, 0); GT_GearStart(2); GT_Delay(3); return 0; }\n",
       "rate = 12\nuntil_ms = 4\nnever = [\"axis2.prfPos > 12\"]\n"},
      // Threads that wait, one of them at the end of its function.
      {"Waits",
       "int go, n;\n"
       "int t0() { n = n + 1; go = n; GT_Delay(1); }\n"
       "int t1() { GT_WaitForVarEq(&go, 1); n = n + 5; go = 2; return n; }\n"
       "int t2() { GT_Delay(2); n = n * 2; GT_WaitForVarEq(&go, 2); }\n",
       "rate = 12\n"},
      {"Deadlock",
       "int go;\nint t0() { GT_WaitForVarEq(&go, 1); return 0; }\n"
       "int t1() { go = 1; go = 2; return 0; }\n",
       "rate = 12\n"},
      {"Reaction",
       "int go, n;\nint t0() { go = 1; GT_SetDoBit(12, 1, 1); go = 0; return 0; }\n"
       "int t1() {\n  int seen;\nL:\n  GT_GetDi(4, &seen);\n  n = seen & 1;\n"
       "  if (n) goto E;\n  GT_Delay(1);\n  goto L;\nE:\n  return 0;\n}\n",
       "rate = 12\nlimit_ms = 6\nfinal = [\"n == 1\"]\n[[world.react]]\n"
       "when = \"gpo[1] == 1 && go == 1\"\nafter_ms = 1\nindex = 1\nvalue = 1\n"},
      {"Arrays",
       "int a[4], i;\nint t0() { i = 1; a[i] = 3; i = 2; a[i] = a[1]; return i; }\n"
       "int t1() { int k; k = a[i]; a[k] = 7; i = a[1]; a[0] = k; return k; }\n",
       "rate = 12\n"},
      // The second thread takes the target of the first one, or changes its motion.
      {"TwoThreads",
       "int t0() { GT_AxisOn(1); GT_PrfTrap(1); GT_SetVel(1, 5); GT_SetPos(1, 20);"
       " GT_Update(1); return 0; }\n"
       "int t1() { GT_SetPos(1, 9); GT_Update(2); GT_Update(1); GT_AxisOn(9);"
       " return 0; }\n",
       "rate = 12\nuntil_ms = 3\nwithin = [{ after = \"axis1.moving == 1\","
       " then = \"axis1.prfPos > 3\", ms = 1 }]\n"},
      {"Assert",
       "int x;\nint t0() { x = 1; x = 0; return 0; }\n"
       "int t1() {\n  GT_Delay(1);\n  //@ assert: x == 0\n  x = 2;\n  return x;\n}\n",
       "rate = 12\neventually = [\"x == 2\"]\n"},
      // The order matters only if both are in one cycle, which the budget decides.
      {"Budget",
       "int a, b, n;\nint t0() { a = 1; a = 2; a = 3; n = 1; return 0; }\n"
       "int t1() { b = 1; b = 2; n = 2; b = 3; return 0; }\n"
       "int t2() { int k; GT_Delay(1); k = n; return k; }\n",
       "rate = 12\n"},
      // Together they have one statement more than there is room for in a cycle.
      {"OneTooMany",
       "int a, b, k;\nint t0() { a = 1; return 0; }\n"
       "int t1() { int c; b = 1; GT_GetClock(&c, &k); }\n",
       "rate = 12\n"},
      // The value that a refused command leaves in its output.
      {"Refused",
       "int g, axis;\nint t0() { axis = 99; axis = 1; return 0; }\n"
       "int t1() { int s; int c; s = 5; GT_GetSts(axis, &s, 1, &c); return s; }\n",
       "rate = 16\n"},
      // A thread that waits begins to run within a cycle.
      {"WakesUp",
       "int go, n;\nint t0() { n = n + 1; go = 1; n = n * 2; return n; }\n"
       "int t1() { GT_WaitForVarEq(&go, 1); n = n + 5; go = 2; return n; }\n"
       "int t2() { GT_Delay(1); n = n * 3; return 0; }\n",
       "rate = 12\n"},
      // A requirement sees a state between two statements that no thread notices.
      {"Visible",
       "int a, b;\nint t0() { a = 1; a = 0; return 0; }\n"
       "int t1() { b = 1; b = 0; return 0; }\n",
       "rate = 100\nnever = [\"a == 1 && b == 1\"]\n"},
      {"AssertBetween",
       "int a;\nint t0() { int n; n = 1; a = 1; a = 0; return n; }\n"
       "int t1() { int n;\nn = 1;\n//@ assert: a == 0\nn = 2;\nreturn n; }\n",
       "rate = 100\n"},
      // A local that only an assert reads.
      {"AssertOfLocal",
       "int t0() { int n; n = 1;\n//@ assert: n == 1\nn = 2;\nreturn 0; }\n"
       "int t1() { return 0; }\n",
       "rate = 100\n"},
      // An axis that has stopped starts again from where it is.
      {"TwoMoves",
       "int t0() { GT_AxisOn(1); GT_PrfTrap(1); GT_SetVel(1, 5); GT_SetPos(1, 4);"
       " GT_Update(1); GT_Delay(3); GT_SetPos(1, 8); GT_Update(1); GT_Delay(1);"
       " GT_Stop(1, 0); GT_Delay(2); return 0; }\n"
       "int g; int t1() { int n; n = 3;\nL: g = n; n = n - 1; if (n) goto L; return 0; }\n",
       "rate = 12\nuntil_ms = 7\nfinal = [\"axis1.prfPos > 4\"]\n"},
  };
  return kMachines;
}

}  // namespace oncard::explore
