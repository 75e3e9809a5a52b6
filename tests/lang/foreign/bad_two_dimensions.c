int grid[3][4]; // expect error MP111
int v;
int t0() {
  int i;
  grid[1][2] = 4;
  while (grid[i][2] < 9) { // expect error MP101
    grid[i][2] = grid[i][2] + 1;
  }
  if (grid[i][0]) v = 2; // expect error MP045
  return 0;
}
