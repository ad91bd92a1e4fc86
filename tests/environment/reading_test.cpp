#include "src/environment/reading.hpp"

#include "src/environment/panorama.hpp"
#include "src/environment/radiance_encoding.hpp"
#include "src/environment/radiance_pyramid.hpp"
#include "tests/environment/sky.hpp"
#include "tests/support/environment_lookup.hpp"
#include "tests/support/hdr_writing.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

constexpr const char* name = "'a.hdr'";

/// A dim picture with one bright pixel.
Bytes oneBright(int width, int height, int brightX, int brightY, float radiance) {
    return hdrOf(width, height, [=](int x, int y) {
        return glm::vec3(x == brightX && y == brightY ? radiance : 0.1f);
    });
}

glm::vec3 brightestDirection(const Environment& environment) {
    const OctahedralMap grid(64);
    glm::vec3 best(0.0f);
    float most = 0.0f;
    for (int y = 0; y < grid.size(); ++y)
        for (int x = 0; x < grid.size(); ++x) {
            const glm::vec3 direction = grid.direction(x, y);
            const float value = test::environmentSpecular(environment, direction, 0.0f).g;
            if (value <= most) continue;
            most = value;
            best = direction;
        }
    return best;
}

} // namespace

TEST(ReadEnvironment, TheMiddleColumnLooksAlongMinusZ) {
    struct Case {
        int x, y;
        glm::vec3 direction;
    };
    // Pixels are 6 degrees wide, so that a corner's direction is at most 5 from their middle.
    for (const Case& seen :
         {Case{30, 14, {0, 0, -1}}, Case{15, 14, {-1, 0, 0}}, Case{45, 14, {1, 0, 0}},
          Case{0, 14, {0, 0, 1}}, Case{59, 14, {0, 0, 1}}, Case{20, 0, {0, 1, 0}},
          Case{20, 29, {0, -1, 0}}}) {
        const Environment environment =
            readEnvironment(oneBright(60, 30, seen.x, seen.y, 20.0f), name);
        const glm::vec3 found = brightestDirection(environment);
        EXPECT_GT(glm::dot(found, seen.direction), 0.98f) << seen.x << ", " << seen.y;
        EXPECT_GT(glm::dot(glm::vec3(environment.diffuse[3].g, environment.diffuse[1].g,
                                     environment.diffuse[2].g),
                           seen.direction),
                  0.0f);
    }
}

TEST(ReadEnvironment, MeanLuminanceIsOneUnlessItIsAsStored) {
    const Bytes file =
        panoramaOf(64, 32, [](const glm::vec3& d) { return glm::vec3(9.0f, 3.0f, 1.0f + d.y); });
    const float mean = 0.2126f * 9.0f + 0.7152f * 3.0f + 0.0722f * 1.0f;
    const Environment scaled = readEnvironment(file, name);
    const Environment stored = readEnvironment(file, name, EnvironmentScale::asStored);
    EXPECT_NEAR(stored.diffuse[0].r, 9.0f, 0.05f);
    EXPECT_NEAR(stored.diffuse[0].g, 3.0f, 0.03f);
    EXPECT_NEAR(scaled.diffuse[0].r, 9.0f / mean, 0.03f);
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    EXPECT_NEAR(test::environmentSpecular(scaled, up, 0.3f).r, 9.0f / mean, 0.03f);
    EXPECT_NEAR(test::environmentSpecular(stored, up, 0.3f).r, 9.0f, 0.1f);
}

TEST(ReadEnvironment, LargePicturesAreAveragedToTheSameLight) {
    const auto sky = [](const glm::vec3& d) { return glm::vec3(lopsidedSky(glm::dvec3(d))); };
    const Environment small = readEnvironment(panoramaOf(512, 256, sky), name);
    const Environment large = readEnvironment(panoramaOf(2050, 1027, sky), name);
    for (const glm::vec3& direction : testDirections())
        for (const float roughness : {0.0f, 0.2f, 0.6f}) {
            const glm::vec3 expected = test::environmentSpecular(small, direction, roughness);
            EXPECT_LT(
                glm::length(test::environmentSpecular(large, direction, roughness) - expected),
                0.02f * glm::length(expected) + 0.05f);
        }
}

TEST(ReadEnvironment, ASunKeepsItsLightInTheMap) {
    // A single pixel of a large picture, in the middle of the sky and near the zenith.
    for (const int row : {40, 180, 250}) {
        const Bytes bytes = oneBright(1024, 512, 300, row, 5e4f);
        RadianceFile file(bytes, name);
        const Panorama panorama(file);
        const double stored = 5e4 * panorama.solidAngle(row);
        const Environment environment = readEnvironment(bytes, name, EnvironmentScale::asStored);
        const OctahedralMap grid(62);
        double found = 0.0;
        for (int y = 0; y < grid.size(); ++y)
            for (int x = 0; x < grid.size(); ++x)
                found +=
                    static_cast<double>(grid.solidAngle(x, y)) *
                    (static_cast<double>(
                         test::environmentSpecular(environment, grid.direction(x, y), 1.0f).g) -
                     0.1);
        EXPECT_NEAR(found / stored, 1.0, 0.2) << row;
    }
}

TEST(ReadEnvironment, ExtremeRadianceStaysFinite) {
    const auto extreme = [](int x, int y) {
        return glm::vec3(x == 3 && y == 2 ? 1e38f : 1e-30f, 0.0f, 1.0f);
    };
    for (const EnvironmentScale scale : {EnvironmentScale::meanOne, EnvironmentScale::asStored}) {
        const Environment environment = readEnvironment(hdrOf(16, 8, extreme), name, scale);
        for (const glm::vec3& direction : testDirections()) {
            EXPECT_LT(glm::length(test::environmentDiffuse(environment, direction)), 1e9f);
            EXPECT_LE(test::environmentSpecular(environment, direction, 0.5f).r,
                      1.001f * largestEncodedRadiance);
        }
    }
}

TEST(ReadEnvironment, TheSmallestPictureIsEnough) {
    const Environment environment =
        readEnvironment(hdrOf(1, 1, [](int, int) { return glm::vec3(0.5f); }), name);
    for (const glm::vec3& direction : testDirections())
        EXPECT_NEAR(test::environmentSpecular(environment, direction, 0.4f).g, 1.0f, 0.01f);
}

TEST(ReadEnvironment, WhatIsNoEnvironmentIsRefusedByName) {
    const TempFolder folder;
    const auto refuse = [&](const std::string& file, const Bytes& bytes, const char* word) {
        const auto path = folder.write(file, bytes);
        expectInputError([&] { readEnvironment(path); }, {file.c_str(), word});
    };
    const Bytes sound = panoramaOf(16, 8, [](const glm::vec3&) { return glm::vec3(1.0f); });
    EXPECT_NO_THROW(readEnvironment(folder.write("sound.hdr", sound)));
    refuse("empty.hdr", {}, "is not a Radiance picture");
    refuse("cut.hdr", Bytes(sound.begin(), sound.end() - 1), "ends within row 7 of 8");
    refuse("black.hdr", hdrOf(16, 8, [](int, int) { return glm::vec3(0.0f); }), "black all over");
    expectInputError([&] { readEnvironment(folder / "missing.hdr"); }, {"missing.hdr", "exist"});
}

} // namespace edgeshade::test
