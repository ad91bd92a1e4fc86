// The light that the display shows as this sRGB colour, for surfaces whose colour must survive the
// later mapping (tone_mapping.glsl). Bright colours keep their hue, but not all of their
// saturation.
vec3 lightShownAs(vec3 color) {
    vec3 light = linearFromSrgb(color);
    float most = max(light.r, max(light.g, light.b));
    if (most > shown) {
        float room = 1.0 - shown;
        float kept = min(most, 0.999);
        light *= (room * room / (1.0 - kept) + shown - room) / most;
    }
    float least = min(light.r, min(light.g, light.b));
    return light + (least < reflected ? 2.0 * sqrt(reflected * least) - least : reflected);
}
