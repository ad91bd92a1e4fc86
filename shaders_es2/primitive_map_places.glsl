// The places that primitive_map_points.glsl counts, as uniforms.
uniform highp vec4 u_placesX[4]; // x of 16 places, in map space
uniform highp vec4 u_placesY[4];
uniform highp vec4 u_placesZ[4];
uniform highp float u_placesW; // of all places; 0: they are directions
uniform highp vec4 u_placesCounted[4]; // 1, or 0 for an unused place
uniform highp vec4 u_mapEye;           // the eye in map space, homogeneous
#define PRIMITIVE_PLACES_X(k) u_placesX[k]
#define PRIMITIVE_PLACES_Y(k) u_placesY[k]
#define PRIMITIVE_PLACES_Z(k) u_placesZ[k]
#define PRIMITIVE_PLACES_COUNTED(k) u_placesCounted[k]
#define PRIMITIVE_PLACES_W u_placesW
#define PRIMITIVE_TOWARDS_EYE(a) (u_mapEye.xyz - u_mapEye.w * (a))
