//@ structured
// A static function that nothing calls may hold what cannot be translated.
int v;
static int first(int **list) { return **list; } // expect warning MP219
static void text(void); // its remark is at the definition
static void text(void) { v = "text"; } // expect warning MP219
static int both(int **list) { return first(list) + both(list); } // expect warning MP219
static long long wide(void) { return 1; } // expect warning MP219
static int again(int n) { return n > 0 ? again(n - 1) : 0; }
static int fine(int n) { return n; }
void t0(void) {
  v = fine(3);
}
// expect: v=3
