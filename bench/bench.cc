// `oncard_bench WHAT`: measures one subject, each in a file of its own. The results of what is
// compared are compared too, so that none is faster because it computes something else.
#include <cstdio>
#include <string_view>

#include "bench/measure.h"

namespace oncard::bench {
namespace {

struct Subject {
  std::string_view name;
  void (*measure)();
};

constexpr Subject kSubjects[] = {
    {"vm", BenchVm},           {"run", BenchRun},         {"motion", BenchMotion},
    {"explore", BenchExplore}, {"session", BenchSession}, {"editor", BenchEditor},
};

int Main(int argc, char** argv) {
  const std::string_view what = argc == 2 ? argv[1] : "";
  for (const Subject& subject : kSubjects) {
    if (subject.name != what) continue;
    subject.measure();
    return 0;
  }
  std::fprintf(stderr, "usage: oncard_bench vm|run|motion|explore|session|editor\n");
  return 2;
}

}  // namespace
}  // namespace oncard::bench

int main(int argc, char** argv) { return oncard::bench::Main(argc, argv); }
