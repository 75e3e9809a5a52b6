//@ structured
#define LARGER(a, b) ((a) > (b) ? (a) : (b))
#define TEXT(a) #b // expect error MP210
#define JOIN(a, b) a##b## // expect error MP210
#define LARGER(a, b) 0 // expect error MP013
#define SPLIT 1\
2 // expect error MP211 @6
int a = LARGER(1); // expect error MP209
int b = LARGER(1, 2, 3); // expect error MP209
int c = LARGER(1, 2;  // expect error MP213
