// expect ok
//@ never: x == 7
// Blanks do not matter; what begins with another word is not for the compiler.
//@ asserted: x
int x;
int t0() {
  //@assert :x == 0
  x = 1;
  //@ assert: x == 1
end:
  return x;
}
