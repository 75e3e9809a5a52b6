//@ structured
// Arrays of structures, arrays in structures, and both: copied, initialised, with computed indices.
struct axis {
  int target;
  short gains[3];
  double velocity;
};
struct machine {
  struct axis axes[2];
  int state;
  int grid[2][3];
};
struct axis axis[3] = {{10, {1, 2, 3}, 0.5}, {20, {4}}, 30, 5, 6, 7, 1.5};
struct machine machine = {{{1, {2, 3, 4}, 5}, [1].gains[1] = 6, 7, 8}, 9, {{1}, 2, 3}}, other;
struct machine rows[2][2];
struct axis sized[] = {[1] = {1}, {.gains = {[2] = 9}}};
struct {
  int steps[8];
  int last;
} wide, narrow = {.last = 4, .steps = {[5 ... 6] = 3}};
int elements, moved, at, local, runs, filled, counted, index, sum, second, kept, sizes;
static int next(void) { return runs++; }
void t0(int start) {
  int i = start + 1;
  struct axis copy = axis[i], list[2] = {axis[2], {.target = 5, axis[0].gains[1]}};
  struct machine here = {{copy, list[1]}, .grid[1] = {4, 5, 6}};
  elements = axis[i].target + axis[i + 1].gains[i] + axis[0].gains[2];
  axis[next()] = copy;
  axis[next()].target += 7;
  axis[next()].gains[i]++;
  moved = axis[0].target * 10000 + axis[1].target * 100 + axis[2].gains[1] * 10 + runs;
  other = machine;
  other.axes[i] = axis[2];
  other.grid[i][i + 1] = 70;
  rows[i][0] = other;
  rows[0][i] = rows[i][i - 1];
  at = rows[0][1].axes[1].gains[1] * 1000 + rows[0][i].grid[1][2] + rows[0][1].axes[0].gains[2];
  local = list[0].target * 100 + list[1].gains[0] * 10 + list[1].target;
  filled = here.axes[0].target * 100 + here.axes[1].target * 10 + here.grid[1][1] + here.state;
  counted = sizeof(sized) / sizeof(sized[0]) * 100 + sized[2].gains[2] * 10 + sized[1].target;
  wide = narrow;
  narrow.steps[3] = 1;
  sum = 0;
  for (i = 0; i < 8; i++) sum = sum * 3 + wide.steps[i];
  sum += wide.last;
  i = 1;
  axis[i] = axis[i - 1];
  kept = axis[1].target == axis[0].target && axis[1].velocity == axis[0].velocity;
  second = machine.axes[1].gains[1] * 100 + machine.axes[1].gains[2] * 10 + machine.grid[1][0];
  sizes = sizeof(struct axis) + sizeof(machine.axes) * 100;
  //@ assert: axis[1].gains[2] == 0 && machine.axes[0].target == 1
  index = machine.grid[0][0];
}
// expect: elements=29, moved=202773, at=7074, local=3025, filled=2055, counted=391, sum=40
// expect: kept=1, second=672, sizes=4824, axis_target[1]=20, axis_gains[5]=0, wide_steps[6]=3, index=1
