int v; // expect error MP119 @2
/* this is never closed
int w;
