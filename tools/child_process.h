// Runs a program to its end and keeps what it prints. Tested by tests/tools/child_process_test.cc
// and host_tests_test.cc.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace oncard::tools {

struct ChildProgram {
  std::vector<std::string> words;  ///< the program, which is searched for as in a shell, arguments
  std::string folder = {};         ///< in which it runs; empty: the present one
  std::vector<std::string> environment = {};  ///< `NAME=value`, added
  int limit_s = 0;  ///< seconds of the wall clock after which it is killed; 0: none
};

struct ChildEnd {
  int status = 0;  ///< as of waitpid()
  bool out_of_time = false;
  std::string output;  ///< standard output and standard error, the last kOutputKept bytes
};

/// How much of a program's output is kept.
inline constexpr size_t kOutputKept = 65536;

/// The program reads nothing, and is killed when this process ends. Fails if it cannot be started.
/// To be called while the process has only one thread.
Result<ChildEnd> RunChild(const ChildProgram& program);

/// Called in a new process: it is killed when the one that started it, `parent`, ends.
void DieWithParent(int parent);

}  // namespace oncard::tools
