// The first four moments of distances around a place: their mean and what moments around it say. Side by
// side in a texture twice as wide as the map; in the left texel mean and standard deviation, in the right
// one the skewness s and the kurtosis k, as s / sqrt(1 + s^2), half of it plus a half, and as what k is more
// than its least, 1 + s^2, by k. 16 bits each: moments themselves, of a share of the map's depth that is
// small, would have lost their digits.
struct Moments {
    float mean, second, third, fourth; // around the mean
};

Moments unpackMoments(vec4 left, vec4 right) {
    Moments of;
    of.mean = unpackHalf(left.rg);
    float deviation = unpackHalf(left.ba);
    float turned = 2.0 * unpackHalf(right.rg) - 1.0;
    float skewness = turned / sqrt(max(1.0 - turned * turned, 1e-5));
    float kurtosis = (1.0 + skewness * skewness) / max(1.0 - unpackHalf(right.ba), 1e-4);
    of.second = deviation * deviation;
    of.third = of.second * deviation * skewness;
    of.fourth = of.second * of.second * kurtosis;
    return of;
}

// Left texel or right one.
vec4 packMoments(Moments of, float part) {
    if (part < 0.5) return vec4(packHalf(of.mean), packHalf(sqrt(of.second)));
    float unit = 1.0 / max(of.second, 1e-12);
    float skewness = of.third * unit * sqrt(unit), kurtosis = of.fourth * unit * unit;
    float least = 1.0 + skewness * skewness;
    return vec4(packHalf(0.5 + 0.5 * skewness * inversesqrt(least)),
                packHalf(1.0 - least / max(kurtosis, least)));
}

// Sums of weight times moments around `from`; weights add up to 1.
struct MomentSum {
    float from;
    vec4 sum;
};

void addMoments(inout MomentSum to, Moments of, float weight) {
    float d = of.mean - to.from, dd = d * d;
    to.sum += weight * vec4(d, dd + of.second, dd * d + 3.0 * d * of.second + of.third,
                            dd * dd + 6.0 * dd * of.second + 4.0 * d * of.third + of.fourth);
}

Moments momentsOf(MomentSum of) {
    float m = of.sum.x, mm = m * m;
    Moments result;
    result.mean = of.from + m;
    result.second = max(of.sum.y - mm, 0.0);
    result.third = of.sum.z - 3.0 * m * of.sum.y + 2.0 * mm * m;
    result.fourth = max(of.sum.w - 4.0 * m * of.sum.z + 6.0 * mm * of.sum.y - 3.0 * mm * mm, 0.0);
    return result;
}
