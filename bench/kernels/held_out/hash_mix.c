/* Mixes the upper halves of n numbers of a linear congruential generator into a hash. */
int hash_mix(int n)
{
    int x, upper, hash, cc;
    x = 12345;
    hash = 0;
loop:
    x = x * 1664525;
    x = x + 1013904223;
    upper = x >> 16;
    upper = upper & 65535;
    hash = hash ^ upper;
    hash = hash * 31;
    n = n - 1;
    if (n) goto loop;
    return hash;
}
