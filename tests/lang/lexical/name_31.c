int a234567890123456789012345678901; // expect ok
int t0() { return 0; }
