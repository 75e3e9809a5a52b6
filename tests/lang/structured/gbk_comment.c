//@ structured
// The second byte of the last character of a comment, in GBK, is that of a backslash.
// expect: v=7, w=3
int v, w;
void t0() {
  int k;
  k = 3;  // Ô\
  v = 7;  // Õ\ 
  w = k;  /* Ô\*/
  k = 0;  // a backslash of ASCII after a whole character continues the comment: Äã\
  v = 0;
}
