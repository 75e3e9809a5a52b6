int f(a) { return 0; } // expect error MP005
int g(int a[3]) { return 0; } // expect error MP124
int h(TTrapPrm t) { return 0; } // expect error MP124
int k(int) { return 0; } // expect error MP128
int m(void v) { return 0; } // expect error MP124
