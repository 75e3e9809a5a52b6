//@ structured
// Functions that call themselves and need no depth: their calls begin with constants and count down.
// expect: factorial=5040, fibonacci=55, moves=15, even=1, halves=6
int factorial, fibonacci, moves, even, halves;

int fact(int n) { return n <= 1 ? 1 : n * fact(n - 1); }

int fib(int n) {
  if (n < 2) return n;
  return fib(n - 1) + fib(n - 2);
}

void hanoi(int n, int from, int to) {
  if (n > 0) {
    hanoi(n - 1, from, 6 - from - to);
    moves++;
    hanoi(n - 1, 6 - from - to, to);
  }
}

int is_odd(int n);
int is_even(int n) { return n == 0 ? 1 : !!is_odd(n - 1); }
int is_odd(int n) { return n == 0 ? 0 : !!is_even(n - 1); }

int halved(int n) {
  switch (n) {
    case 0:
      return 0;
  }
  if (!(n > 0)) return 0;
  return 1 + halved(n / 2);
}

void t0() {
  factorial = fact(7);
  fibonacci = fib(10);
  hanoi(4, 1, 3);
  even = is_even(10);
  halves = halved(32);
}
