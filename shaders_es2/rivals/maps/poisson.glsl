// Sixteen taps in a disc PCF texels wide, no two nearer to each other than 0.42 of its radius
// (found by throwing darts), rotated by a different angle in every pixel.
float poissonLit(Receiver r, vec3 axisS, vec3 axisT) {
    // Roberts' sequence over pixels gives neighbours angles far apart.
    float angle = 6.2831853 * fract(dot(gl_FragCoord.xy, vec2(0.7548776662, 0.5698402910)));
    vec2 turn = 0.5 * float(PCF) * vec2(cos(angle), sin(angle));
    vec3 s = turn.x * axisS + turn.y * axisT, t = turn.x * axisT - turn.y * axisS;
    float lit = 0.0;
    vec3 tap;
#define TAP(x, y) tap = r.at + (x) * s + (y) * t; lit += planeDistance(r, tap) <= unpackDistance(texelAt(tap)) ? 1.0 : 0.0;
    TAP(-0.3241, -0.5952) TAP(0.7458, 0.6624) TAP(-0.5531, 0.8250) TAP(0.7365, -0.6087)
    TAP(-0.8622, -0.0012) TAP(0.1438, 0.0707) TAP(0.1201, 0.8678) TAP(0.9206, -0.0231)
    TAP(-0.3623, 0.3054) TAP(0.2674, -0.9618) TAP(-0.8541, 0.4525) TAP(0.1211, -0.4756)
    TAP(0.5567, 0.2515) TAP(-0.7830, -0.5633) TAP(-0.3147, -0.1488) TAP(0.4797, -0.1945)
#undef TAP
    return lit / 16.0;
}
