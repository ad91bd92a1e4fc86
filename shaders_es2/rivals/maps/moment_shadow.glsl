// Lower bound of the share of distances with these moments that lie before a place (Peters and
// Klein 2015, the Hamburger moment problem). Of the three distances, one of them the place itself,
// that have these moments, it adds up the weights of those before the place. Works relative to the
// mean in units of the standard deviation, so that floats hold the numbers.
const float momentBlur = 1.5 / 65536.0; // added to the standard deviation, as if distances were
                                        // blurred, against rounding

float shadowByMoments(Moments of, float own) {
    float blur = momentBlur * momentBlur;
    float second = of.second + blur;
    float fourth = of.fourth + 6.0 * of.second * blur + 3.0 * blur * blur;
    float unit = inversesqrt(second);
    float s = of.third * unit * unit * unit, x = (own - of.mean) * unit;
    float rest = max(fourth * unit * unit * unit * unit - 1.0 - s * s, 1e-4);
    // The other two are the roots of a t^2 + b t + c.
    float a = x * x - s * x - 1.0;
    a = abs(a) < 1e-5 ? (a < 0.0 ? -1e-5 : 1e-5) : a;
    float b = x * rest - s * a, c = rest - a;
    float q = -0.5 * (b + (b < 0.0 ? -1.0 : 1.0) * sqrt(max(b * b - 4.0 * a * c, 0.0)));
    q = abs(q) < 1e-12 ? 1e-12 : q;
    float first = q / a, other = c / q;
    float near = min(first, other), far = max(first, other);
    if (x <= near) return 0.0;
    if (x <= far) return clamp((x * far + 1.0) / ((far - near) * (x - near)), 0.0, 1.0);
    return clamp(1.0 - (near * far + 1.0) / ((x - near) * (x - far)), 0.0, 1.0);
}
