dobule d; // expect error MP005
struct S { int x; }; // expect error MP115
typedef int number; // expect error MP115
enum E { A, B }; // expect error MP115
union U { int x; }; // expect error MP115
void v; // expect error MP005
int t0() { return 0; }
