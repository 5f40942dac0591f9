//@ if ANGLE
/*
 * Sine and cosine, below one unit in the last place: the polynomials of FDLIBM (Sun Microsystems, 1993) after a reduction by
 * multiples of a quarter turn in three parts, of which two have few digits. Gives 0 for angles beyond LARGEST_ANGLE.
 */
static int sine_cosine(real angle, real *sine, real *cosine)
{
    const real quarters = angle * (real)0.63661977236758134308;
    int n;
    real x;
    real tail;
    real reduced;
    real rest;
    real z;
    real s;
    real c;
    if (!(magnitude(angle) <= LARGEST_ANGLE)) {
        return 0;
    }
    n = (int)(quarters < (real)0 ? quarters - (real)0.5 : quarters + (real)0.5);
    x = (angle - (real)n * QUARTER_HIGH) - (real)n * QUARTER_MIDDLE;
    tail = (real)n * QUARTER_LOW;
    reduced = x - tail;
    rest = (x - reduced) - tail;
    z = reduced * reduced;
    s = (real)1.58969099521155010221e-10;
    s = s * z - (real)2.50507602534068634195e-08;
    s = s * z + (real)2.75573137070700676789e-06;
    s = s * z - (real)1.98412698298579493134e-04;
    s = s * z + (real)8.33333333332248946124e-03;
    s = reduced - ((z * ((real)0.5 * rest - z * reduced * s) - rest) + z * reduced * (real)1.66666666666666324348e-01);
    c = (real)-1.13596475577881948265e-11;
    c = c * z + (real)2.08757232129817482790e-09;
    c = c * z - (real)2.75573143513906633035e-07;
    c = c * z + (real)2.48015872894767294178e-05;
    c = c * z - (real)1.38888888888741095749e-03;
    c = c * z + (real)4.16666666666666019037e-02;
    x = (real)0.5 * z;
    tail = (real)1 - x;
    c = tail + ((((real)1 - tail) - x) + (z * z * c - reduced * rest));
    switch (n & 3) {
    case 0:
        *sine = s;
        *cosine = c;
        break;
    case 1:
        *sine = c;
        *cosine = -s;
        break;
    case 2:
        *sine = -s;
        *cosine = -c;
        break;
    default:
        *sine = -c;
        *cosine = s;
        break;
    }
    return 1;
}

//@ end
//@ if TURN
/* The angle of a direction (x, y), from -pi to pi, 0 without one: the polynomial of FDLIBM's arc tangent. */
static real angle_of(real y, real x)
{
    const real across = magnitude(y);
    const real along = magnitude(x);
    const real longer = larger(across, along);
    real t;
    real z;
    real even;
    real odd;
    real base = (real)0;
    real angle;
    if (!(longer > (real)0)) {
        return (real)0;
    }
    t = (across < along ? across : along) / longer;
    /* atan t = pi/4 + atan (t - 1) / (t + 1) */
    if (t > (real)0.41421356237309504880) {
        t = ((across < along ? across : along) - longer) / ((across < along ? across : along) + longer);
        base = (real)0.78539816339744830962;
    }
    z = t * t;
    odd = z * z;
    even = (real)1.62858201153657823623e-02;
    even = even * odd + (real)4.97687799461593236017e-02;
    even = even * odd + (real)6.66107313738753120669e-02;
    even = even * odd + (real)9.09088713343650656196e-02;
    even = even * odd + (real)1.42857142725034663711e-01;
    even = z * (even * odd + (real)3.33333333333329318027e-01);
    z = odd;
    odd = (real)-3.65315727442169155270e-02;
    odd = odd * z - (real)5.83357013379057348645e-02;
    odd = odd * z - (real)7.69187620504482999495e-02;
    odd = odd * z - (real)1.11111104054623557880e-01;
    odd = z * (odd * z - (real)1.99999999998764832476e-01);
    angle = base + (t - t * (even + odd));
    if (across > along) {
        angle = (real)1.57079632679489661923 - angle;
    }
    if (x < (real)0) {
        angle = PI - angle;
    }
    return y < (real)0 ? -angle : angle;
}

//@ end
