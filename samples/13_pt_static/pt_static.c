/* GTS manual, example 7-3: three segments in a static FIFO form a trapezoidal velocity. */
#define PT_STATIC 0
#define PT_NORMAL 0

int move(void)
{
  GT_AxisOn(1);
  GT_PrfPt(1, PT_STATIC);
  GT_PtClear(1, 0);
  GT_PtData(1, 1024, 1024, PT_NORMAL, 0);
  GT_PtData(1, 3072, 2048, PT_NORMAL, 0);
  GT_PtData(1, 4096, 3072, PT_NORMAL, 0);
  GT_PtStart(1, 0);
  return 0;
}
