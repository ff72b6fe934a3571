/* Memory bandwidth by the triad a = b + s c (McCalpin, STREAM) on each of the processes that run this side by side.
   Prints bytes per second of this process: the best of five passes over 3 x 400 MB, 24 bytes an entry. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(void)
{
    const size_t n = 50000000;
    double *a = malloc(n * sizeof *a), *b = malloc(n * sizeof *b), *c = malloc(n * sizeof *c), best = 1e30;
    if (!a || !b || !c)
        return 1;
    for (size_t i = 0; i < n; ++i)
        a[i] = 0, b[i] = (double)i, c[i] = 1;
    for (int pass = 1; pass <= 5; ++pass) {
        const double start = seconds();
        for (size_t i = 0; i < n; ++i)
            a[i] = b[i] + pass * c[i];
        const double took = seconds() - start;
        best = took < best ? took : best;
    }
    printf("%.6g %g\n", 24.0 * (double)n / best, a[n / 2]);
    return 0;
}
