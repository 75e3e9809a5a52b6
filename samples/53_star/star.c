//@ structured
/* A star. Change the 9, and run. */
/* 画一颗星。改一改 9，再运行。 */
#define POINTS 9    /* odd */
#define LENGTH 8000 /* of a line, in pulses */
#define SPEED 16    /* pulse/ms */

#define MC_GPI 4
#define MC_GPO 12
#define PEN 1
#define UP 0
#define DOWN 1
#define IN_MOTION 0x400

int lines; /* so many are drawn */
int turn;  /* of the thread that may go on */

/* An axis travels its share of a line, so that both arrive together. */
static void start(int axis, double share, int target) {
  TTrapPrm trap;
  double size = share < 0 ? -share : share;

  trap.acc = 0.25 * size;
  trap.dec = 0.25 * size;
  trap.velStart = 0;
  trap.smoothTime = 0;
  GT_SetTrapPrm(axis, &trap);
  GT_SetVel(axis, SPEED * size);
  GT_SetPos(axis, target);
}

static void prepare(int axis, int position) {
  GT_AxisOn(axis);
  GT_SetPrfPos(axis, position);
  GT_SetEncPos(axis, position);
  GT_PrfTrap(axis);
}

/* Thread 0 draws a line whenever the pen is down. */
void draw(void) {
  /* The tangent of half the angle at a point: 1.5708 is a right angle. */
  double a = 1.5708 / POINTS;
  double t = a + a * a * a / 3 * (1 + 0.4 * a * a);
  double sine = 2 * t / (1 + t * t);
  double cosine = (t * t - 1) / (1 + t * t);
  double x = 3164, y = 1377, dx = 0.6, dy = 0.8;
  int sts[2], clock;

  prepare(1, x);
  prepare(2, y);
  GT_SynchAxisPos(3);
  while (lines < POINTS) {
    GT_WaitForVarEq(&turn, 0);
    x += LENGTH * dx;
    y += LENGTH * dy;
    start(1, dx, x);
    start(2, dy, y);
    GT_Update(3);
    do {
      GT_Delay(1);
      GT_GetSts(1, sts, 2, &clock);
    } while ((sts[0] | sts[1]) & IN_MOTION);
    double ahead = dx * cosine - dy * sine;
    dy = dx * sine + dy * cosine;
    dx = ahead;
    lines++;
    turn = 1;
  }
}

/* An input says where the pen is. */
static void move_pen(int place) {
  int inputs;

  GT_SetDoBit(MC_GPO, PEN, place);
  do {
    GT_Delay(1);
    GT_GetDi(MC_GPI, &inputs);
  } while ((inputs & 1) != place);
}

/* Thread 1 lifts the pen at each point, and puts it down again. */
void pen(void) {
  while (lines < POINTS) {
    move_pen(UP);
    move_pen(DOWN);
    turn = 0;
    GT_WaitForVarEq(&turn, 1);
  }
}
