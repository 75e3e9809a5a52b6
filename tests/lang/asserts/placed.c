// expect ok
//@ never: x == 7
// An assert is one whatever its case of blanks; another word is not for the compiler.
//@ asserted: x
int x;
int t0() {
  //@assert :x == 0
  x = 1;
  //@ assert: x == 1
end:
  return x;
}
