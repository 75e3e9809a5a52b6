//@ structured
// A function that ends with a call of itself is a loop and needs no depth.
// expect: divisor=21, counted=10, ends=1, total=1005, swaps=21, x=5, y=8, last=3, steps=6, again=4
int divisor, counted, ends, total, swaps, x, y, last, steps, again;
int list[4] = {1, 2, 3, 4};

int gcd(int a, int b) { return b == 0 ? a : gcd(b, a % b); }

void count(int n) {
  counted += n;
  if (n > 0) {
    count(n - 1);
    return;
  }
  ends++;
}

// Where a reference begins may change.
int sum(const int *p, int n, int all) {
  if (n == 0) return all;
  return sum(p + 1, n - 1, all + *p);
}

// The arguments are computed before the first parameter changes.
int swap(int a, int b, int n) {
  if (n == 0) return a * 10 + b;
  return swap(b, a, n - 1);
}

struct pair {
  int x, y;
};
struct pair fibonacci(struct pair p, int n) {
  if (n == 0) return p;
  return fibonacci((struct pair){p.y, p.x + p.y}, n - 1);
}

void find(int n, int *to) {
  if (n * n >= 8)
    *to = n;
  else
    find(n + 1, to);
}

//@ depth: 3
int collatz(int n, int count) {
  if (n == 1) return count;
  if (n % 2 == 0) return collatz(n / 2, count + 1);
  return collatz(3 * n + 1, count + 1);
}

// A thread function may be one.
void t0(int n) {
  again++;
  if (n < 3) t0(n + 1);
}
void t1() {
  divisor = gcd(1071, 462);
  count(4);
  total = sum(list, 4, 0) * 100 + sum(&list[1], 2, 0);
  swaps = swap(1, 2, 3);
  struct pair p = fibonacci((struct pair){0, 1}, 5);
  x = p.x;
  y = p.y;
  find(0, &last);
  steps = collatz(10, 0);
}
