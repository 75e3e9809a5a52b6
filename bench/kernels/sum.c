/* Adds begin to end to the global, as the GTS manual's example 10-1 does. */
int sum;
int add(int begin, int end)
{
    int i;
    int cc;
    i = begin;
loop:
    cc = i > end;
    if (cc) goto done;
    sum = sum + i;
    i = i + 1;
    goto loop;
done:
    return sum;
}
