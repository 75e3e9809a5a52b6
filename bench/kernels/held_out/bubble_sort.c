/* Fills an array with 200 pseudo-random numbers and sorts it, n times over: the sum of the medians. */
int bubble_sort(int n)
{
    int a[200];
    int i, next, last, x, kept, total, cc;
    x = 1;
    total = 0;
pass:
    i = 0;
fill:
    x = x * 75;
    x = x + 74;
    x = x % 65537;
    a[i] = x;
    i = i + 1;
    cc = i < 200;
    if (cc) goto fill;
    last = 199;
round:
    i = 0;
compare:
    cc = i >= last;
    if (cc) goto placed;
    next = i + 1;
    cc = a[i] <= a[next];
    if (cc) goto ordered;
    kept = a[i];
    a[i] = a[next];
    a[next] = kept;
ordered:
    i = next;
    goto compare;
placed:
    last = last - 1;
    if (last) goto round;
    total = total + a[100];
    n = n - 1;
    if (n) goto pass;
    return total;
}
