// A box over a floor, in the shadow that edgeshade's mask says: in shadow 51 of 255, lit 204,
// behind everything blue.
#pragma once
#include <edgeshade/shadow_masks.hpp>

constexpr int pictureWidth = 320, pictureHeight = 240;

/// By a shader of its own into what is bound in the context that is current. Throws what edgeshade
/// throws.
void drawPicture(edgeshade::ShadowMasks::LookUp lookUp);

/// Reads it back, into a PPM.
void writePicture(const char* path);
