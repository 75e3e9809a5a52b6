/* Every statement reads or writes a global: no thread can run ahead of the others. */
int count, mixed, low, endless;
int all_shared(int n)
{
    endless = 1;
loop:
    count = count + 1;
    mixed = count ^ mixed;
    low = mixed & 255;
    if (endless) goto loop;
    return n;
}
