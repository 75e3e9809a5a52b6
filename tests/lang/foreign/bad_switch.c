int a;
int t0() {
  switch (a) { // expect error MP105
    case 1:
      a = 2;
      break;
    default:
      a = 3;
  }
  case 4: // expect error MP115
  default: // expect error MP115
  return 0;
}
