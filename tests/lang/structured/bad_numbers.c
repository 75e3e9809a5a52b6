//@ structured
int a = 09; // expect error MP118
int b = 0b12; // expect error MP003
int c = 0xG; // expect error MP003
int d = 12abc; // expect error MP003
int e = 12LL; // expect error MP200
int f = 12ull; // expect error MP200
int g = 12uu; // expect error MP003
int h = 2147483648; // expect error MP026
int i = 4294967296u; // expect error MP026
int j = 0x100000000; // expect error MP026
int k = -2147483649; // expect error MP026
int l = 99999999999999999999; // expect error MP026
double m = 2147483648.0; // expect error MP026
double n = 1.5f; // expect error MP003
int o = 1 - 2147483648; // expect error MP026
int p = 0x40000000000000001; // expect error MP026
int q = 0x10000000000000000; // expect error MP026
#define LONG_LONG 1LL
int r = LONG_LONG; // expect error MP200
#if LONG_LONG > 0x7FFFFFFFFFFFFFFF
#error more than 63 bits
#endif
