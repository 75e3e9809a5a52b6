/* Two threads beside a path that the host sends: `valve` opens a valve between two positions of
   axis 1, `count` counts what it has filled. */
//@ final: filled == 1
//@ never: closed == 1 && opened == 0
#define MC_GPO 12
#define VALVE 1
#define OPEN 1
#define CLOSED 0

int opened;
int closed;
int filled;
double open_at;
double close_at;

int valve()
{
  double position;
  int clock;
  int before;

lbl_before:
  GT_Delay(5);
  GT_GetPrfPos(1, &position, 1, &clock);
  before = position < open_at;
  if (before) goto lbl_before;
  GT_SetDoBit(MC_GPO, VALVE, OPEN);
  opened = 1;
lbl_open:
  GT_Delay(5);
  GT_GetPrfPos(1, &position, 1, &clock);
  before = position < close_at;
  if (before) goto lbl_open;
  GT_SetDoBit(MC_GPO, VALVE, CLOSED);
  closed = 1;
  return 0;
}

int count()
{
  int done;

lbl_wait:
  GT_Delay(7);
  done = opened && closed;
  if (done) goto lbl_count;
  goto lbl_wait;
lbl_count:
  filled = filled + 1;
  return filled;
}
