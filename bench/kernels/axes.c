/* Moves an axis back and forth and watches it: eight threads do so with an axis each. */
TTrapPrm trap;

int drive(int axis)
{
    int mask, bit, target, distance, sts, clock, moving, moves;
    GT_AxisOn(axis);
    GT_PrfTrap(axis);
    trap.acc = 0.25;
    trap.dec = 0.125;
    trap.velStart = 0;
    trap.smoothTime = 25;
    GT_SetTrapPrm(axis, &trap);
    GT_SetVel(axis, 50.0);
    bit = axis - 1;
    mask = 1 << bit;
    distance = axis * 5000;
    target = 0;
    moves = 0;
again:
    target = distance - target;
    GT_SetPos(axis, target);
    GT_Update(mask);
    moves = moves + 1;
wait:
    GT_GetSts(axis, &sts, 1, &clock);
    moving = sts & 1024;
    if (moving) goto wait;
    goto again;
}
