/* Fixed-point multiply-accumulate: a filter's inner loop with constant coefficients. */
double multiply_accumulate(int n)
{
    double x, y, product, acc;
    int i, cc;
    x = 1.0625;
    y = 0.984375;
    acc = 0;
    i = 1;
loop:
    cc = i > n;
    if (cc) goto done;
    product = x * y;
    acc = acc + product;
    i = i + 1;
    goto loop;
done:
    return acc;
}
