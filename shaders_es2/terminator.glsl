// Coarse meshes with smooth normals show the facets of their own shadow where light grazes them: a
// facet is dark while its normals still say lit. This dims the light before that, so that it
// reaches 0 where the facet turns away (Chiang, Li, Burley, Taming the shadow terminator, 2019).
// SOFT_TERMINATOR: this is done. Include eye.glsl first.

// The share of the light that is left, 0..1; `normal` points towards the eye.
float lightAtTerminator(vec3 normal, vec3 light) {
#ifdef SOFT_TERMINATOR
    vec3 facet = cross(dFdx(v_fromEye), dFdy(v_fromEye));
    float size = dot(facet, facet);
    if (!(size > 0.0)) return 1.0;
    facet *= inversesqrt(size);
    if (dot(facet, towardsEye()) < 0.0) facet = -facet;
    float turned = dot(facet, light);
    float shaded = dot(normal, light) * dot(facet, normal);
    if (turned <= 0.0 || shaded <= 0.0) return 0.0;
    float share = min(turned / shaded, 1.0);
    return share * (1.0 + share - share * share);
#else
    return 1.0;
#endif
}
