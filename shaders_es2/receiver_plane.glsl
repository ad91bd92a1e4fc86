// Treats the receiver around a lookup as a plane, so that wide filters don't shadow it by itself
// (Isidoro 2006). Needs the declarations of shadow_map_lookup.glsl.

struct Receiver {
    vec3 at;    // in map space
    float own;  // its distance
    vec3 plane; // its normal there
};

Receiver receiverAt(vec3 at, vec3 normal) {
    Receiver r;
    r.at = at;
    r.own = distanceOf(at);
#ifdef MAP_DIRECTIONAL
    r.plane = u_mapFromWorld * normal / (u_mapScale * u_mapScale);
#else
    r.plane = normal;
#endif
    return r;
}

// Distance of the plane at a tap.
float planeDistance(Receiver r, vec3 tap) {
    vec3 aside = tap - r.at;
#ifdef MAP_DIRECTIONAL
    float steepest = steepSlope * length(aside.xy / u_mapScale.xy) * abs(u_mapScale.z);
    float rise = -dot(r.plane.xy, aside.xy) / min(r.plane.z, -1e-6);
    return min(r.own + min(rise, steepest), 1.0);
#else
    float distance = dot(r.plane, r.at) / min(dot(r.plane, tap), -1e-6) * length(tap);
    return min(min(distance, r.own + steepSlope * length(aside)), 1.0);
#endif
}
