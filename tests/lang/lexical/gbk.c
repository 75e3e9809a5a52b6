/* 累加求和 程序 */
int v; // 变量，注释
int t0() {
  v = 6; // 赋值 expect ok
  return 0; // expect: v=6
}
