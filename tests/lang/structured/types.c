//@ structured
unsigned a; unsigned int b; signed char c; unsigned char d; short e; unsigned short int f;
long g; long int h; unsigned long i; signed j; int long unsigned k; const static int l = 1;
bool m; _Bool n; double o; TTrapPrm p; TJogPrm q; TPid r; enum { kA } s; volatile int t;
