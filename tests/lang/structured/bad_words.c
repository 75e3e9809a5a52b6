//@ structured
struct Point { int x; int y; };
struct Point origin;
union Word { int all; char bytes[4]; } word; // expect error MP206
typedef struct { int x; } pair;
typedef int (*handler)(int); // expect error MP206
typedef int *place; // expect error MP129
typedef int function(int a); // expect error MP206
pair pairs[2];
int (*callback)(int); // expect error MP206
int print(int format, ...); // expect error MP206
_Static_assert(sizeof(int) == 4); // expect error MP206
void f(int (*each)(int)); // expect error MP206
void g(int *(*rows)[4]); // expect error MP206
struct Flags { unsigned low : 4; } flags; // expect error MP206
int g(enum { kA } a); // expect error MP206
enum { kB } h(int a); // expect error MP206
int i = sizeof(enum { kC }); // expect error MP206
void t0() {
  int c;
  asm("nop"); // expect error MP206
  __asm__ volatile ("nop"); // expect error MP206
  goto *c; // expect error MP206
  c = &&end; // expect error MP206
  c = ({ 1; }); // expect error MP206
end:
}
