int v;
v = 1; // expect error MP030
GT_Update(1); // expect error MP015
label: // expect error MP011
goto label; // expect error MP030
if (v) return; // expect error MP030
int t0() { return 0; }
