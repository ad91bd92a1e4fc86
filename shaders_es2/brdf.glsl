// glTF 2.0, appendix B: light that a microfacet surface sends to the eye. All terms are multiplied
// by pi, because a light's unit is what a white Lambert surface reflects of it.

// Trowbridge-Reitz (GGX) times Smith's visibility, correlated by height; `alpha`: roughness
// squared.
float microfacets(float alpha, float nl, float nv, float nh) {
    float square = alpha * alpha;
    float tail = nh * nh * (square - 1.0) + 1.0;
    float masking = nl * sqrt(nv * nv * (1.0 - square) + square) +
                    nv * sqrt(nl * nl * (1.0 - square) + square);
    return square / (tail * tail) * 0.5 / max(masking, 1e-5);
}

// Schlick's weight for reflection at grazing angles.
float grazing(float cosine) {
    float away = 1.0 - clamp(cosine, 0.0, 1.0);
    float square = away * away;
    return square * square * away;
}

// Share of uniform light from all directions that a white surface reflects: (scale, bias) of its
// reflectance at normal incidence, as fitted by Karis (Physically based shading on mobile, 2014).
vec2 reflectedFromEverywhere(float roughness, float nv) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a + r.zw;
}
