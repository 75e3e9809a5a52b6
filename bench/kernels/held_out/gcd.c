/* Sum of the greatest common divisors of n and each of 1 to n, by Euclid's algorithm. */
int gcd(int n)
{
    int i, a, b, rest, total, cc;
    total = 0;
    i = 1;
next:
    cc = i > n;
    if (cc) goto done;
    a = n;
    b = i;
divide:
    cc = b == 0;
    if (cc) goto add;
    rest = a % b;
    a = b;
    b = rest;
    goto divide;
add:
    total = total + a;
    i = i + 1;
    goto next;
done:
    return total;
}
