// main() of test programs that draw. Loading a GL for each context, and asking the system again
// for the memory of each map, took longer than most tests draw.
#include "tests/support/kept_gl.hpp"

#include <gtest/gtest.h>

#include <climits>
#include <malloc.h>

int main(int argc, char** argv) {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, INT_MAX);
    edgeshade::test::keepGlLoaded();
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
