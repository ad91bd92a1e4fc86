#include "preprocess/base/sha256.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace edgeshade {
namespace {

std::string hashOf(const std::string& text) {
    return sha256(std::vector<std::uint8_t>(text.begin(), text.end()));
}

} // namespace

TEST(Sha256, HasThePublishedValues) {
    // FIPS 180-4's examples (NIST, Cryptographic Standards and Guidelines).
    EXPECT_EQ(hashOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hashOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hashOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(hashOf(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DiffersForTextsAroundABlock) {
    // Lengths at which the padding takes a block more.
    std::vector<std::string> hashes;
    for (std::size_t length = 50; length < 70; ++length)
        hashes.push_back(hashOf(std::string(length, 'x')));
    for (std::size_t i = 1; i < hashes.size(); ++i)
        EXPECT_NE(hashes[i], hashes[i - 1]);
}

} // namespace edgeshade
