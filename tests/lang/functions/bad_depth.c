// The card's language has no calls of own functions, so nothing for a depth.
int v;
// expect error MP247 @4
//@ depth: 4
int main() {
  v = 1;
  return 0;
}
