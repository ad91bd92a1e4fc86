// Chooses the cascade in which a place is looked up: the finest that holds the place and the whole
// filter around it. Near that cascade's border the next one is looked up too.
uniform vec4 u_cascades[MAP_CASCADES]; // xy: scale and zw: offset from a place's xy to a cascade's
                                       // texture
uniform float u_cascadeMargin;         // farthest that a lookup may reach, as a share of the
                                       // texture
// Width of the border in which two cascades are blended, as a share of the texture.
const float cascadeBorder = 0.05;

// The cascade in use.
vec4 mapCascade;
float mapFace;

void useCascade(int index) {
    for (int i = 0; i < MAP_CASCADES; ++i)
        if (i == index) {
            mapCascade = u_cascades[i];
            mapFace = float(i);
        }
}

// Returns the cascade; `next` gets the weight of the one after it.
int cascadeOf(vec2 at, out float next) {
    int index = MAP_CASCADES - 1;
    next = 0.0;
    float inCoarser = 0.0;
    for (int i = MAP_CASCADES - 1; i >= 0; --i) {
        vec2 aside = abs(at * u_cascades[i].xy + u_cascades[i].zw - 0.5);
        float within = 0.5 - u_cascadeMargin - max(aside.x, aside.y);
        if (within > 0.0) {
            index = i;
            next = clamp(min(1.0 - within / cascadeBorder, inCoarser / cascadeBorder), 0.0, 1.0);
        }
        inCoarser = within;
    }
    return index;
}
