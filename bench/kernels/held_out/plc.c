/* A filling station as a state machine: waits for a bottle, fills it, closes it, moves it on; an
   overflow stops it until it is acknowledged. The inputs follow from the cycle's number. */
#define WAITING 0
#define FILLING 1
#define CLOSING 2
#define MOVING 3

int plc(int n)
{
    int cycle, inputs, bottle, full, overflow, state, timer, bottles, stops, cc;
    state = WAITING;
    timer = 0;
    bottles = 0;
    stops = 0;
    cycle = 0;
loop:
    cc = cycle >= n;
    if (cc) goto done;
    inputs = cycle >> 3;
    inputs = inputs ^ cycle;
    bottle = inputs & 1;
    full = inputs & 6;
    overflow = inputs & 56;
    cc = state == WAITING;
    if (cc) goto waiting;
    cc = state == FILLING;
    if (cc) goto filling;
    cc = state == CLOSING;
    if (cc) goto closing;
    cc = state == MOVING;
    if (cc) goto moving;
    state = WAITING;
    cc = overflow == 56;
    if (cc) goto stopped;
    goto end;
stopped:
    stops = stops + 1;
    state = 4;
    goto end;
waiting:
    cc = !bottle;
    if (cc) goto end;
    state = FILLING;
    timer = 20;
    goto end;
filling:
    timer = timer - 1;
    cc = overflow == 56;
    if (cc) goto stopped;
    cc = full == 6;
    if (cc) goto filled;
    if (timer) goto end;
filled:
    state = CLOSING;
    timer = 3;
    goto end;
closing:
    timer = timer - 1;
    if (timer) goto end;
    state = MOVING;
    timer = 5;
    goto end;
moving:
    timer = timer - 1;
    if (timer) goto end;
    bottles = bottles + 1;
    state = WAITING;
end:
    cycle = cycle + 1;
    goto loop;
done:
    stops = stops * 1000;
    bottles = bottles + stops;
    return bottles;
}
