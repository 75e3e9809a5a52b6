//@ structured
// Types with names: numbers, enums, arrays, also local ones and those that a local hides.
typedef unsigned char byte, bytes[4];
typedef enum { kIdle, kRun = 5 } state;
typedef enum state2 { kStop = 7 } state2;
typedef const int fixed;
typedef int row[3];
typedef row matrix[2];
typedef signed char int8_t;
typedef byte byte;
typedef double real;
fixed LIMIT = 3;
matrix m = {{1, 2, 3}, {4}};
bytes b = {255, 256};
state now = kRun;
real half;
int sizes, sum, hidden, cast, inner, wraps, more;
static int total(const row values, byte extra) {
  typedef int row;
  row result = extra;
  for (int i = 0; i < LIMIT; i++) result += values[i];
  return result;
}
static byte narrow(int x) { return x; }
int twice(state2 row) { return row * 2; }
void t0(void) {
  typedef short local[2];
  local pair = {70000, 1};
  byte wrap = 250;
  int8_t small = 200;
  {
    int byte = 1000;
    hidden = byte + 1;
  }
  sizes = sizeof(matrix) * 10000 + sizeof(bytes) * 1000 + sizeof(local) * 100 + sizeof m[0];
  sum = total(m[0], 300) + total(m[1], 1);
  wrap += 10;
  cast = (byte)511 + (real)1;
  inner = pair[0] + small;
  wraps = wrap * 1000 + narrow(257);
  more = twice(kStop) + now;
  half = (real)1 / 2;
}
// expect: b[0]=255, b[1]=0, now=5, m[2]=3, m[3]=4, m[4]=0, hidden=1001, sizes=244412
// expect: sum=55, cast=256, inner=4408, wraps=4001, more=19, half=0.5
