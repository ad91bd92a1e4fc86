// Multiplicities worked out manually. The comments use this rule: turn every triangle so that the
// light sees it counter-clockwise; an edge's multiplicity is the number of triangles that run from
// its smaller to its larger vertex minus the number that run back. At each vertex, arrivals equal
// departures.
#include "tests/support/record_multiplicity.hpp"
#include "tests/support/tiny_meshes.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

using namespace shader_arithmetic;

/// On small integers every sign is exact, so all methods agree.
void expectSilhouette(const Soup& soup, const glm::vec4& light, const Silhouette& expected) {
    const SidesData sides = build(soup).sides;
    EXPECT_EQ(silhouetteOf<ReferenceEdge>(sides, light), expected);
    EXPECT_EQ(silhouetteOf<ThreeEdge>(sides, light), expected);
    EXPECT_EQ(silhouetteOf<SingleEdge>(sides, light), expected);
}

// The cube's corners, bottom and top.
constexpr Point c000 = {0, 0, 0}, c100 = {1, 0, 0}, c010 = {0, 1, 0}, c110 = {1, 1, 0};
constexpr Point c001 = {0, 0, 1}, c101 = {1, 0, 1}, c011 = {0, 1, 1}, c111 = {1, 1, 1};

/// A < B in one triangle, with C on all sides: A = (0,0,0), B = (0,1,0), C = (1,0,0).
const Soup oneTriangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};

} // namespace

TEST(Multiplicity, OfATriangleSeenClockwiseInOrder) {
    // From above A -> B -> C is clockwise, so the triangle runs A -> C -> B -> A.
    //   B
    //   |\.
    //   A-C
    expectSilhouette(oneTriangle, {0, 0, 5, 1},
                     {{{c000, c010}, -1}, {{c000, c100}, 1}, {{c010, c100}, -1}});
}

TEST(Multiplicity, ChangesSignOnTheOtherSide) {
    expectSilhouette(oneTriangle, {0, 0, -5, 1},
                     {{{c000, c010}, 1}, {{c000, c100}, -1}, {{c010, c100}, 1}});
}

TEST(Multiplicity, OfATriangleDoesNotDependOnItsWinding) {
    Soup turned = oneTriangle;
    std::swap(turned.indices[0], turned.indices[1]);
    expectSilhouette(turned, {0, 0, 5, 1},
                     {{{c000, c010}, -1}, {{c000, c100}, 1}, {{c010, c100}, -1}});
}

TEST(Multiplicity, IsZeroWithTheLightInThePlane) {
    expectSilhouette(oneTriangle, {5, 5, 0, 1}, {});         // a point beside it
    expectSilhouette(oneTriangle, {0.25f, 0.25f, 0, 1}, {}); // inside it
    expectSilhouette(oneTriangle, {1, 0, 0, 1}, {});         // on a vertex
    expectSilhouette(oneTriangle, {3, 2, 0, 0}, {});         // in its plane
}

TEST(Multiplicity, OfACubeFromAboveIsTwoAroundTheTop) {
    // The top faces the light, all other faces turn away: on a rim edge both triangles run the
    // same way. From above the rim runs 001 -> 101 -> 111 -> 011 -> 001.
    expectSilhouette(
        cube(), {0.5f, 0.5f, 3, 1},
        {{{c001, c101}, 2}, {{c101, c111}, 2}, {{c011, c111}, -2}, {{c001, c011}, -2}});
}

TEST(Multiplicity, OfACubeUnderTheSunIsOneAtTopAndBottom) {
    // The four upright faces are edge-on and add 0; top and bottom run the same way as seen from
    // above.
    expectSilhouette(cube(), {0, 0, 1, 0},
                     {{{c001, c101}, 1},
                      {{c101, c111}, 1},
                      {{c011, c111}, -1},
                      {{c001, c011}, -1},
                      {{c000, c100}, 1},
                      {{c100, c110}, 1},
                      {{c010, c110}, -1},
                      {{c000, c010}, -1}});
}

TEST(Multiplicity, OfACubeWithTheLightInItsTopPlane) {
    // The face x = 1 faces the light, the top adds 0, the rest faces away. From the light the face
    // runs 100 -> 110 -> 111 -> 101; its upper edge borders only on the top, hence 1. At the top's
    // other edges the faces below them decide.
    expectSilhouette(cube(), {3, 0.5f, 1, 1},
                     {{{c100, c110}, 2},
                      {{c110, c111}, 2},
                      {{c101, c111}, -1},
                      {{c100, c101}, -2},
                      {{c001, c101}, 1},
                      {{c011, c111}, -1},
                      {{c001, c011}, -1}});
}

TEST(Multiplicity, OfACubeWithTheLightInsideIsZero) {
    // Every face is turned away: neighbours cancel.
    expectSilhouette(cube(), {0.5f, 0.25f, 0.5f, 1}, {});
}

TEST(Multiplicity, OfAnOpenBoxIsOneAroundTheRim) {
    // All faces are turned away from a light above or inside: only at the rim nothing cancels.
    const Silhouette rim{
        {{c001, c101}, 1}, {{c101, c111}, 1}, {{c011, c111}, -1}, {{c001, c011}, -1}};
    expectSilhouette(openBox(), {0.5f, 0.5f, 3, 1}, rim);
    expectSilhouette(openBox(), {0.5f, 0.5f, 0.5f, 1}, rim);
}

namespace {
constexpr Point finA = {0, 0, 0}, finB = {0, 0, 1}, finP = {-1, 0, 0}, finQ = {1, 0, 0},
                finF = {0, 1, 0};
}

TEST(Multiplicity, OfAFinSumsThreePages) {
    // Light behind the pages P and Q and to the right of F. P is the smallest, Q the largest.
    //   P A B: normal (A-P) x (B-P) = (0,-1,0), away: -1.   It runs P -> B -> A -> P.
    //   A B Q: normal (0,1,0), towards: +1.                 It runs A -> B -> Q -> A.
    //   A B F: normal (-1,0,0), away: -1.                   It runs A -> F -> B -> A.
    expectSilhouette(fin(), {2, 3, 0.5f, 1},
                     {{{finA, finB}, -1},
                      {{finP, finA}, -1},
                      {{finP, finB}, 1},
                      {{finA, finQ}, -1},
                      {{finB, finQ}, 1},
                      {{finA, finF}, 1},
                      {{finB, finF}, -1}});
}

TEST(Multiplicity, OfAFinWithTheLightInTwoPages) {
    // P and Q are edge-on and add 0.
    expectSilhouette(fin(), {5, 0, 0.5f, 1},
                     {{{finA, finB}, -1}, {{finA, finF}, 1}, {{finB, finF}, -1}});
}

TEST(Multiplicity, OfAFinUnderASunAlongItsSpineIsZero) {
    expectSilhouette(fin(), {0, 0, 1, 0}, {});
}

namespace {
int fanSpine(const glm::vec4& light) {
    const Silhouette silhouette = silhouetteOf<ReferenceEdge>(build(fan(128)).sides, light);
    const auto spine = silhouette.find({{0, 0, 0}, {0, 0, 1}});
    return spine == silhouette.end() ? 0 : spine->second;
}
} // namespace

TEST(Multiplicity, OfAFansSpineSumsAllItsRecords) {
    // Page k: normal (B-A) x (O-A) = (-k, 1, 0), O last. Its sign is that of y - k x for a light
    // at (x, y).
    EXPECT_EQ(fanSpine({1, -1, 0.5f, 1}), -128);   // all -1
    EXPECT_EQ(fanSpine({0, 1, 0, 0}), 128);        // all +1
    EXPECT_EQ(fanSpine({1, 63.5f, 0.5f, 1}), 0);   // 64 of +1, 64 of -1
    EXPECT_EQ(fanSpine({1, 31.5f, 0.5f, 1}), -64); // 32 of +1, 96 of -1
    EXPECT_EQ(fanSpine({1, 5, 0.5f, 1}), -117);    // 5 of +1, page 5 edge-on, 122 of -1
    EXPECT_EQ(fanSpine({0, 0, 7, 1}), 0);          // on the spine's line: all edge-on
}

TEST(Multiplicity, OfAMoebiusStripNeedsNoOrientation) {
    // From above: 012 clockwise, 123 counter-clockwise, 234, 034 and 014 clockwise. So they run
    // 0 2 1, 1 2 3, 2 4 3, 0 4 3 and 0 4 1; 12 and 23 are run both ways and cancel.
    constexpr Point p0 = {0, 0, 0}, p1 = {1, 2, 1}, p2 = {2, 0, 2}, p3 = {3, 2, 3}, p4 = {4, 0, 5};
    const Silhouette fromAbove{{{p0, p1}, -2}, {{p0, p2}, 1},  {{p0, p3}, -1}, {{p0, p4}, 2},
                               {{p1, p3}, -1}, {{p1, p4}, -1}, {{p2, p4}, 1},  {{p3, p4}, -2}};
    expectSilhouette(moebiusStrip(), {0, 0, 1, 0}, fromAbove);
    expectSilhouette(moebiusStrip(), {2, 1, 100, 1}, fromAbove);
    // 012 and 123 lie in the plane x = z, and so does this light; the other three run as before.
    expectSilhouette(moebiusStrip(), {1, 9, 1, 1},
                     {{{p0, p1}, -1},
                      {{p0, p3}, -1},
                      {{p0, p4}, 2},
                      {{p1, p4}, -1},
                      {{p2, p3}, -1},
                      {{p2, p4}, 1},
                      {{p3, p4}, -2}});
}

TEST(Multiplicity, OfDuplicateTrianglesIsTwoWhateverTheirWinding) {
    const Silhouette twice{{{c000, c010}, -2}, {{c000, c100}, 2}, {{c010, c100}, -2}};
    Soup same = oneTriangle, opposite = oneTriangle;
    same.indices.insert(same.indices.end(), {0, 1, 2});
    opposite.indices.insert(opposite.indices.end(), {0, 2, 1});
    expectSilhouette(same, {0, 0, 5, 1}, twice);
    expectSilhouette(opposite, {0, 0, 5, 1}, twice);
    expectSilhouette(opposite, {1, 2, 0, 0}, {});
}

TEST(Multiplicity, OfATJunctionBalancesAlongItsLine) {
    // From above: A -> D -> C -> A, A -> M -> E -> A, M -> C -> E -> M. On the line A M C the side
    // of A-C runs against those of A-M and M-C; on M-E both cancel. Order: A, D, M, E, C.
    constexpr Point a = {0, 0, 0}, m = {1, 0, 0}, c = {2, 0, 0}, d = {1, -1, 0}, e = {1, 1, 0};
    expectSilhouette(tJunction(), {1, 0, 5, 1},
                     {{{a, d}, 1},
                      {{d, c}, 1},
                      {{a, c}, -1},
                      {{a, m}, 1},
                      {{m, c}, 1},
                      {{e, c}, -1},
                      {{a, e}, -1}});
    expectSilhouette(tJunction(), {7, 3, 0, 1}, {});
}

} // namespace edgeshade::test
