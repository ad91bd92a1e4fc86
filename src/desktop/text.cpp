#include "src/desktop/text.hpp"

#include <algorithm>
#include <stb_easy_font.h>

namespace edgeshade::desktop {
namespace {

using viewer::OverlayTriangles;
using viewer::OverlayVertex;

constexpr float columnGap = 14.0f;
constexpr float margin = 6.0f;         // around the text, times its scale
constexpr std::size_t perLetter = 300; // most bytes that stb_easy_font takes, by its own
                                       // documentation

/// A vertex of stb_easy_font's output: four for each rectangle.
struct FontVertex {
    float x, y, z;
    unsigned char color[4];
};

std::string printable(std::string text) {
    for (char& c : text)
        if ((c < 0x20 || c > 0x7E) && c != '\n' && c != '\t') c = '?';
    return text;
}

/// The text's first or second column; both have all lines.
std::string columnOf(const std::string& text, bool second) {
    std::string column;
    bool inSecond = false;
    for (const char c : text) {
        if (c == '\n') inSecond = false;
        if (c == '\t')
            inSecond = true;
        else if (c == '\n' || inSecond == second)
            column += c;
    }
    return column;
}

void addRectangle(OverlayTriangles& triangles, const OverlayVertex& topLeft,
                  const glm::vec2& size) {
    const auto corner = [&](float x, float y) {
        OverlayVertex vertex = topLeft;
        vertex.position += glm::vec2(x, y);
        return vertex;
    };
    for (const glm::vec2& at :
         {glm::vec2(0, 0), glm::vec2(size.x, 0), size, glm::vec2(0, 0), size, glm::vec2(0, size.y)})
        triangles.push_back(corner(at.x, at.y));
}

/// Adds one column's letters; returns its width, unscaled.
float addLetters(OverlayTriangles& triangles, std::string column, const glm::vec2& origin,
                 float scale) {
    std::vector<FontVertex> letters(perLetter * column.size() / sizeof(FontVertex) + 4);
    unsigned char white[4] = {245, 245, 245, 255};
    const int quads = stb_easy_font_print(0.0f, 0.0f, column.data(), white, letters.data(),
                                          static_cast<int>(letters.size() * sizeof(FontVertex)));
    for (int q = 0; q < quads; ++q) {
        const FontVertex* corners = &letters[static_cast<std::size_t>(q) * 4];
        OverlayVertex topLeft{origin + scale * glm::vec2(corners[0].x, corners[0].y), {}};
        std::copy_n(corners[0].color, 4, topLeft.color);
        addRectangle(triangles, topLeft,
                     scale * glm::vec2(corners[2].x - corners[0].x, corners[2].y - corners[0].y));
    }
    return static_cast<float>(stb_easy_font_width(column.data()));
}

} // namespace

float textHeight(const std::string& text, float scale) {
    std::string copy = printable(text);
    return scale * (static_cast<float>(stb_easy_font_height(copy.data())) + 2.0f * margin);
}

OverlayTriangles textTriangles(const std::string& text, float x, float y, float scale) {
    const std::string clean = printable(text);
    const glm::vec2 origin(x + scale * margin, y + scale * margin);
    OverlayTriangles letters;
    float width = addLetters(letters, columnOf(clean, false), origin, scale);
    if (clean.find('\t') != std::string::npos) {
        width += columnGap;
        width += addLetters(letters, columnOf(clean, true), origin + glm::vec2(scale * width, 0.0f),
                            scale);
    }
    OverlayTriangles triangles;
    addRectangle(triangles, {{x, y}, {20, 22, 26, 190}},
                 {scale * (width + 2.0f * margin), textHeight(text, scale)});
    triangles.insert(triangles.end(), letters.begin(), letters.end());
    return triangles;
}

} // namespace edgeshade::desktop
