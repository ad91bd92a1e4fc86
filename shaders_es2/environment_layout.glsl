// How an environment's atlas is laid out and its radiance encoded. What makes it (C++) and what
// looks it up (GLSL ES 1.00) include this file.

// The atlas in texels: powers of two, as GLES 2 wants them. Its tiles are octahedral maps, one a
// level of roughness, each with a border of one texel: level 0 at the left, 1 and 2 beside it, the
// others in a row below these.
#define ENVIRONMENT_WIDTH 512.0
#define ENVIRONMENT_HEIGHT 256.0
#define ENVIRONMENT_MIRROR_TILE 256.0 // level 0
#define ENVIRONMENT_GLOSSY_TILE 128.0 // levels 1 and 2
#define ENVIRONMENT_ROUGH_TILE 64.0   // from level 3 on

// Perceptual roughness 0 to 1 in even steps.
#define ENVIRONMENT_LAST_LEVEL 6.0
