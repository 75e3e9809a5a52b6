/* Running sums of an array in place, n times over. */
int prefix_sum(int n)
{
    int a[1000];
    int i, s, cc;
    i = 0;
fill:
    a[i] = 1;
    i = i + 1;
    cc = i < 1000;
    if (cc) goto fill;
pass:
    s = 0;
    i = 0;
loop:
    cc = i >= 1000;
    if (cc) goto next;
    s = s + a[i];
    a[i] = s;
    i = i + 1;
    goto loop;
next:
    n = n - 1;
    if (n) goto pass;
    return s;
}
