// Which of a sun's maps a place is looked up in: the finest one that holds it with all that is looked
// up around it, and near its border the next one, too.
uniform vec4 u_cascades[MAP_CASCADES]; // a place's xy, times xy, plus zw: in a cascade's texture
uniform float u_cascadeMargin;         // what lookups may reach, as a share of the texture
// How wide the border is in which two are blended, as a share of the texture.
const float cascadeBorder = 0.05;

// What is being looked up.
vec4 mapCascade;
float mapFace;

void useCascade(int index) {
    for (int i = 0; i < MAP_CASCADES; ++i)
        if (i == index) {
            mapCascade = u_cascades[i];
            mapFace = float(i);
        }
}

// Returns the cascade; in `next` the share that the one after it has.
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
