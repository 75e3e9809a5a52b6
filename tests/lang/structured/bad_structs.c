//@ structured
struct node { int value; struct node *next; }; // expect error MP129
struct open { int n; int data[]; }; // expect error MP206
struct empty {}; // expect error MP206
struct outer { struct { int hidden; }; int seen; }; // expect error MP206
struct flags { unsigned low : 4; } flags; // expect error MP206
struct values { int v = 3; }; // expect error MP206
struct words { static int v; }; // expect error MP206
struct strings { char *name; }; // expect error MP129
union word { int all; char bytes[4]; } word; // expect error MP206
int f(struct inside { int a; } b); // expect error MP206
int n = sizeof(struct { int a; }); // expect error MP206
void t0(void) {
  n = flags.low;
}
