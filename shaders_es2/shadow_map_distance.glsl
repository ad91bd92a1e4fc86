// A distance in [0, 1) as four bytes, a 32-bit fixed-point number: colour buffers of WebGL 1 can
// hold that. Every step is exact in highp floats.

vec4 packDistance(float distance) {
    vec4 bytes;
    float rest = clamp(distance, 0.0, 0.99999994) * 256.0;
    bytes.r = floor(rest);
    rest = (rest - bytes.r) * 256.0;
    bytes.g = floor(rest);
    rest = (rest - bytes.g) * 256.0;
    bytes.b = floor(rest);
    bytes.a = floor((rest - bytes.b) * 256.0);
    return bytes / 255.0;
}

float unpackDistance(vec4 texel) {
    vec4 bytes = floor(texel * 255.0 + 0.5);
    return ((bytes.a / 256.0 + bytes.b) / 256.0 + bytes.g) / 65536.0 + bytes.r / 256.0;
}
