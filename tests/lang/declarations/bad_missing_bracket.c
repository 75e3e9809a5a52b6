int a 3]; // expect error MP047
int b[3; // expect error MP042
int t0() { return 0; }
