// Two threads that add to one variable: what the seeds' schedules and search files were made of.
int sum, turns[2];

int t0() {
  int i;
  sum = sum + 1;
  turns[0] = sum;
  i = 0;
  sum = sum + turns[i];
  return sum;
}

int t1() {
  int copy;
  copy = sum;
  sum = copy + 7;
  turns[1] = sum;
  return copy;
}
