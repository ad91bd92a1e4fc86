// The first four moments of the distances around a place: their mean and the moments around it, 16
// bits each. They lie side by side in a texture twice as wide as the map: mean and standard
// deviation in the left texel, skewness s and kurtosis k in the right one. s is stored as 0.5 + 0.5
// s / sqrt(1 + s^2); k as 1 - (1 + s^2) / k, where 1 + s^2 is the least k possible. Raw moments
// would lose their digits where they are a small share of the map's depth.
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

// The left texel (part 0) or the right one (part 1).
vec4 packMoments(Moments of, float part) {
    if (part < 0.5) return vec4(packHalf(of.mean), packHalf(sqrt(of.second)));
    float unit = 1.0 / max(of.second, 1e-12);
    float skewness = of.third * unit * sqrt(unit), kurtosis = of.fourth * unit * unit;
    float least = 1.0 + skewness * skewness;
    return vec4(packHalf(0.5 + 0.5 * skewness * inversesqrt(least)),
                packHalf(1.0 - least / max(kurtosis, least)));
}

// Sums of weights times moments around `from`; the weights add up to 1.
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
