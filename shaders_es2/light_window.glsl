// The share of a light's own strength that arrives at a point: 0 where it doesn't reach. Variants:
// RANGED, the window to a range, see Light; SPOT, the factor of a spot, see Cone; FALLOFF, a light in
// candela, which falls off with the square of the distance.
#ifdef RANGED
uniform float u_inverseRange;
#endif
#ifdef SPOT
uniform float u_inverseOuter; // 1 / (1 - cos(outer))
uniform float u_coneScale;    // (1 - cos(outer)) / (cos(inner) - cos(outer)), less for hard edges
varying vec3 v_cone;          // with the light at 0 and its axis along z
#endif

float lightWindow() {
    float window = 1.0;
#ifdef RANGED
    vec3 reached = v_towardsLight * u_inverseRange;
    float share = dot(reached, reached);
    window = max(1.0 - share * share, 0.0);
#endif
#ifdef SPOT
    // Scaled before it is squared. 1 - cos = sin^2 / (1 + cos), which stays precise for narrow
    // cones.
    vec3 place = v_cone / max(max(abs(v_cone.x), abs(v_cone.y)), max(abs(v_cone.z), 1e-30));
    float aside = dot(place.xy, place.xy);
    float squared = aside + place.z * place.z;
    float cosine = place.z * inversesqrt(squared);
    float away = aside / (squared * (1.0 + max(cosine, 0.0))) * u_inverseOuter;
    float spot = cosine > 0.0 ? clamp((1.0 - away) * u_coneScale, 0.0, 1.0) : 0.0;
    window *= spot * spot;
#endif
#ifdef FALLOFF
    window /= max(dot(v_towardsLight, v_towardsLight), 1e-12);
#endif
    return window;
}
