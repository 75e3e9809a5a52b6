/* Number of primes below 1000 by the sieve of Eratosthenes, n times over. */
int sieve(int n)
{
    int prime[1000];
    int i, multiple, count, cc;
pass:
    i = 2;
mark:
    prime[i] = 1;
    i = i + 1;
    cc = i < 1000;
    if (cc) goto mark;
    count = 0;
    i = 2;
look:
    cc = i >= 1000;
    if (cc) goto passed;
    cc = prime[i] == 0;
    if (cc) goto next;
    count = count + 1;
    multiple = i + i;
strike:
    cc = multiple >= 1000;
    if (cc) goto next;
    prime[multiple] = 0;
    multiple = multiple + i;
    goto strike;
next:
    i = i + 1;
    goto look;
passed:
    n = n - 1;
    if (n) goto pass;
    return count;
}
