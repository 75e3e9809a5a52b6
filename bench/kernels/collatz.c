/* Steps of the Collatz sequences that start at 1 to n. */
int collatz(int n)
{
    int i, x, odd, steps, cc;
    steps = 0;
    i = 1;
start:
    cc = i > n;
    if (cc) goto done;
    x = i;
step:
    cc = x == 1;
    if (cc) goto next;
    steps = steps + 1;
    odd = x % 2;
    if (odd) goto up;
    x = x / 2;
    goto step;
up:
    x = x * 3;
    x = x + 1;
    goto step;
next:
    i = i + 1;
    goto start;
done:
    return steps;
}
