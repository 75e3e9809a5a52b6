//@ structured
// Comments that say how deep functions may call themselves.
int v;
int odd(int n);
// expect error MP247 @6
//@ depth: many
// expect error MP247 @8
//@ depth: 0
// expect error MP247 @10
//@ depth: 1025
// expect error MP247 @12
//@ depth

//@ depth: 8
int even(int n) { return n == 0 ? 1 : odd(n - 1) + 0; }
// expect error MP247 @17
//@ depth: 9
int odd(int n) { return n == 0 ? 0 : even(n - 1) + 0; }
// expect error MP247 @20
//@ depth: 3
int plain(int n) { return n; }
// expect error MP247 @25
void t0() {
  v = even(2) + plain(1);
  //@ depth: 2
}

//@ depth: 7
// expect error MP247 @31

//@ depth: 6
