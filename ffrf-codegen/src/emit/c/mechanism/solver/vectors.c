/* A not a number and an infinity are neither. */
static int is_finite(real x)
{
    return (real)0 * x >= (real)0;
}

static real larger(real a, real b)
{
    return a > b ? a : b;
}

static real magnitude(real x)
{
    return x < (real)0 ? -x : x;
}

static real dot(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const real a[3], const real b[3], real product[3])
{
    const real x = a[1] * b[2] - a[2] * b[1];
    const real y = a[2] * b[0] - a[0] * b[2];
    const real z = a[0] * b[1] - a[1] * b[0];
    product[0] = x;
    product[1] = y;
    product[2] = z;
}

static void add_scaled(int count, real factor, const real *numbers, real *sum)
{
    int k;
    for (k = 0; k < count; k++) {
        sum[k] += factor * numbers[k];
    }
}

static void fill(int count, real value, real *numbers)
{
    int k;
    for (k = 0; k < count; k++) {
        numbers[k] = value;
    }
}

static void copy(int count, const real *from, real *to)
{
    int k;
    for (k = 0; k < count; k++) {
        to[k] = from[k];
    }
}

/* The vector that has these components along the axes of a triad, which stand one after the other. */
static void along_axes(const real axes[9], const real components[3], real vector[3])
{
    real sum[3];
    int k;
    for (k = 0; k < 3; k++) {
        sum[k] = axes[k] * components[0] + axes[3 + k] * components[1] + axes[6 + k] * components[2];
    }
    copy(3, sum, vector);
}

/* The components of a vector along the axes. */
static void components_along(const real axes[9], const real vector[3], real components[3])
{
    const real x = dot(&axes[0], vector);
    const real y = dot(&axes[3], vector);
    const real z = dot(&axes[6], vector);
    components[0] = x;
    components[1] = y;
    components[2] = z;
}

static void quaternion_product(const real a[4], const real b[4], real product[4])
{
    product[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
    product[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
    product[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
    product[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

/* The axes of a triad, one after the other, from its Euler parameters. */
static void axes_of(const real orientation[4], real axes[9])
{
    const real w = orientation[0];
    const real i = orientation[1];
    const real j = orientation[2];
    const real k = orientation[3];
    const real i2 = i + i;
    const real j2 = j + j;
    const real k2 = k + k;
    axes[0] = (real)1 - (j * j2 + k * k2);
    axes[1] = i * j2 + w * k2;
    axes[2] = i * k2 - w * j2;
    axes[3] = i * j2 - w * k2;
    axes[4] = (real)1 - (i * i2 + k * k2);
    axes[5] = j * k2 + w * i2;
    axes[6] = i * k2 + w * j2;
    axes[7] = j * k2 - w * i2;
    axes[8] = (real)1 - (i * i2 + j * j2);
}

/* An orientation turned by the Cayley map of a rotation vector, which has the components of the frame that turns. */
static void turned(const real orientation[4], const real rotation[3], real result[4])
{
    real turn[4];
    real product[4];
    real norm;
    int k;
    turn[0] = (real)1;
    for (k = 0; k < 3; k++) {
        turn[1 + k] = (real)0.5 * rotation[k];
    }
    quaternion_product(orientation, turn, product);
    norm = square_root(
        product[1] * product[1] + product[2] * product[2] + product[3] * product[3] + product[0] * product[0]
    );
    for (k = 0; k < 4; k++) {
        result[k] = product[k] / norm;
    }
}

/* The rate of a rotation vector whose Cayley map turns a frame, when the frame turns with omega in its own components. */
static void cayley_rate(const real rotation[3], const real omega[3], real rate[3])
{
    real half[3];
    real product[3];
    real projection;
    int k;
    for (k = 0; k < 3; k++) {
        half[k] = (real)0.5 * rotation[k];
    }
    cross(half, omega, product);
    projection = dot(half, omega);
    for (k = 0; k < 3; k++) {
        rate[k] = omega[k] + product[k] + half[k] * projection;
    }
}
