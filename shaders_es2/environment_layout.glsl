// Layout of an environment's atlas, and the encoding of its radiance. Both the code that makes the
// atlas (C++) and the shaders that sample it (GLSL ES 1.00) include this file.

// Size of the atlas in texels: powers of two, as GLES 2 requires. Its tiles are octahedral maps,
// one per level of roughness, each with a border of one texel: level 0 at the left, levels 1 and 2
// beside it, the others in a row below those.
#define ENVIRONMENT_WIDTH 512.0
#define ENVIRONMENT_HEIGHT 256.0
#define ENVIRONMENT_MIRROR_TILE 256.0 // level 0
#define ENVIRONMENT_GLOSSY_TILE 128.0 // levels 1 and 2
#define ENVIRONMENT_ROUGH_TILE 64.0   // from level 3 on

// Levels divide perceptual roughness, 0 to 1, into even steps.
#define ENVIRONMENT_LAST_LEVEL 6.0
