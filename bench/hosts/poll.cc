// A host that moves eight axes and reads their positions every millisecond for ten minutes:
// `poll THREADS [blocked]`. Each of the threads polls; with `blocked` one more waits for input that
// never comes.
#include <unistd.h>

#include <cstdlib>
#include <thread>
#include <vector>

#include "gts.h"

namespace {

constexpr short kAxes = 8;
constexpr int kPolls = 600'000;

void Poll() {
  double positions[kAxes];
  for (int poll = 0; poll < kPolls; ++poll) {
    if (GT_GetPrfPos(1, positions, kAxes) != 0) std::exit(1);
    ::usleep(1000);
  }
}

void WaitForInput() {
  int ends[2];
  char input = 0;
  if (::pipe(ends) != 0 || ::read(ends[0], &input, 1) != 0) std::exit(1);
}

bool MoveAxes() {
  TJogPrm jog = {0.5, 0.5, 0};
  for (short axis = 1; axis <= kAxes; ++axis) {
    if (GT_AxisOn(axis) != 0 || GT_PrfJog(axis) != 0 || GT_SetJogPrm(axis, &jog) != 0 ||
        GT_SetVel(axis, 10 + axis) != 0) {
      return false;
    }
  }
  return GT_Update((1 << kAxes) - 1) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 1 ? std::atoi(argv[1]) : 1;
  if (GT_Open() != 0 || !MoveAxes()) return 1;
  if (argc > 2) std::thread(WaitForInput).detach();
  std::vector<std::thread> others;
  for (int thread = 1; thread < threads; ++thread) others.emplace_back(Poll);
  Poll();
  for (std::thread& other : others) other.join();
  std::exit(0);
}
