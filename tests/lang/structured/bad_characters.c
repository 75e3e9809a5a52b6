//@ structured
int a = 'ab'; // expect error MP201
int b = ''; // expect error MP201
int c = '\q'; // expect error MP201
int d = '\x'; // expect error MP201
int e = '\777'; // expect error MP201
int f = 'é'; // expect error MP201
