//@ structured
// Values for chosen elements: those that follow go on from there, later ones replace earlier ones,
// and what has none is 0.
enum { kX, kY, kZ };
int a[6] = {[2] = 5, 6, [0] = 1}, b[] = {[3] = 7}, sizes;
int m[3][4] = {[1] = {9, 8}, [2][1] = 3, 4, [0][3] = 2, 5};
int n[2][3] = {{[1] = 1, 2}, [1] = 6, 7}, r[5] = {[0 ... 2] = 4, [1] = 3, [4] = 1};
int over[2][2] = {1, 2, 3, 4, [0] = {[1] = 6}};
TTrapPrm trap = {.dec = 0.5, 2, .acc = 1};
int p, q, s, t, u, v;
double w;
void t0(int k) {
  int c[] = {[kZ] = k + 3, [kX] = a[2]};
  TJogPrm jog = {.dec = 1.5};
  static const int table[4] = {[kY] = 11, 12};
  sizes = sizeof b / sizeof b[0] * 100 + sizeof(c) / sizeof(int);
  p = c[0] * 100 + c[1] * 10 + c[2];
  q = table[0] * 1000 + table[1] * 10 + table[2];
  w = jog.dec + jog.acc + trap.velStart;
  u = trap.dec * 10 + trap.acc;
}
// expect: a[0]=1, a[1]=0, a[2]=5, a[3]=6, b[3]=7, b[0]=0, sizes=403
// expect: m[3]=2, m[4]=5, m[5]=8, m[6]=0, m[9]=3, m[10]=4
// expect: n[0]=0, n[1]=1, n[2]=2, n[3]=6, n[4]=7, r[0]=4, r[1]=3, r[2]=4, r[3]=0, r[4]=1
// expect: over[0]=0, over[1]=6, over[2]=3, over[3]=4
// expect: p=503, q=122, w=3.5, u=6
