#pragma once // expect error MP034
#ifdef X // expect error MP034
int t0() { return 0; }
