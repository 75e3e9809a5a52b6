/* A fixed-point low-pass filter of second order, fed with a square wave: the sum of its output. The
   signal is positive throughout. */
double biquad(int n)
{
    double x, x1, x2, y, y1, y2, part, total;
    int i, phase, cc;
    x = 0.25;
    x1 = 0;
    x2 = 0;
    y1 = 0;
    y2 = 0;
    total = 0;
    phase = 0;
    i = 0;
loop:
    cc = i >= n;
    if (cc) goto done;
    phase = phase + 1;
    cc = phase < 100;
    if (cc) goto filter;
    phase = 0;
    x = 1.25 - x;
filter:
    y = 0.01 * x;
    part = 0.02 * x1;
    y = y + part;
    part = 0.01 * x2;
    y = y + part;
    part = 1.6 * y1;
    y = y + part;
    part = 0.64 * y2;
    y = y - part;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    total = total + y;
    i = i + 1;
    goto loop;
done:
    return total;
}
