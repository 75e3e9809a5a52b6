//@ structured
// Functions that call themselves, alone and in circles: what a call needs afterwards it keeps.
// expect: factorial=5040, fibonacci=55, ackermann=9, moves=2937, even=1, odd=0, buffer=2112
// expect: total=41014, low=-10, high=8, half=3.75, swapped=21, out=6
// expect: data[0]=1, data[1]=2, data[2]=3, data[3]=5, data[4]=6, data[5]=7, data[6]=8, data[7]=9
// expect: copy[0]=0, copy[1]=1, copy[2]=2, copy[3]=3, copy[4]=9
int factorial, fibonacci, ackermann, moves, even, odd, buffer, total, low, high, swapped, out;
int data[8] = {5, 2, 9, 1, 7, 3, 8, 6}, copy[5];
double half;

//@ depth: 20

//@ depth: 7
// The only comment that is for one function alone.
int fact(int n) { return n <= 1 ? 1 : n * fact(n - 1); }

int fib(int n) {
  if (n < 2) return n;
  return fib(n - 1) + fib(n - 2);
}

int ack(int m, int n) {
  if (m == 0) return n + 1;
  if (n == 0) return ack(m - 1, 1);
  return ack(m - 1, ack(m, n - 1));
}

void hanoi(int n, int from, int to) {
  if (n == 0) return;
  hanoi(n - 1, from, 6 - from - to);
  moves = moves * 3 + to;
  hanoi(n - 1, 6 - from - to, to);
}

int is_odd(int n);
int is_even(int n) {
  if (n == 0) return 1;
  return is_odd(n - 1);
}
int is_odd(int n) {
  if (n == 0) return 0;
  return is_even(n - 1);
}

// References to what all calls share.
void swap(int *a, int *b) {
  int t = *a;
  *a = *b;
  *b = t;
}
void sort(int *a, int low, int high) {
  if (low >= high) return;
  int i = low, j;
  for (j = low; j < high; j++)
    if (a[j] < a[high]) {
      swap(&a[i], &a[j]);
      i++;
    }
  swap(&a[i], &a[high]);
  sort(a, low, i - 1);
  sort(a, i + 1, high);
}
int sum(const int *a, int n) {
  if (n == 0) return 0;
  return *a + sum(a + 1, n - 1);
}
void add(int n, int *to) {
  if (n == 0) return;
  add(n - 1, to);
  *to += n;
}

// Structures as parameters, locals and results.
struct range {
  int low, high;
};
struct range span(struct range r, int n) {
  struct range next;
  if (n == 0) return r;
  next.low = r.low - n;
  next.high = r.high + n;
  next = span(next, n - 1);
  next.low += r.low;
  return next;
}

// An array that each call has, and parameters that change places.
int order(int a, int b, int n) {
  int digits[2] = {a, b};
  if (n == 0) return 0;
  int rest = order(b, a, n - 1);
  return rest * 100 + digits[0] * 10 + digits[1];
}

double halves(double x, int n) { return n == 0 ? 0 : x / 2 + halves(x / 2, n - 1); }

void t0() {
  factorial = fact(7);
  fibonacci = fib(10);
  ackermann = ack(2, 3);
  hanoi(3, 1, 3);
  even = is_even(6);
  odd = is_odd(6);
  sort(data, 0, 7);
  int mine[5] = {3, 1, 2, 9, 0};
  sort(mine, 0, 4);
  for (int i = 0; i < 5; i++) copy[i] = mine[i];
  total = sum(data, 8) * 1000 + sum(&mine[2], 3);
  struct range s = span((struct range){1, 2}, 3);
  low = s.low;
  high = s.high;
  buffer = order(1, 2, 2);
  swapped = order(2, 1, 1);
  half = halves(4, 4);
  add(3, &out);
}
