#include "tests/settings/generated.hpp"

#include "preprocess/base/file_io.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace edgeshade::test {

void expectGenerated(const std::string& file, const std::string& section, const std::string& text) {
    const std::string path = EDGESHADE_ROOT "/" + file;
    const Bytes bytes = readFile(path);
    const std::string whole(bytes.begin(), bytes.end());
    const std::size_t begin = whole.find(section + ": begin"), end = whole.find(section + ": end");
    ASSERT_TRUE(begin < end && end != std::string::npos) << path << " lacks " << section;
    const std::size_t start = whole.find('\n', begin) + 1, stop = whole.rfind('\n', end) + 1;
    if (std::getenv("EDGESHADE_UPDATE_DOCS"))
        writeFile(path, std::string_view(whole.substr(0, start) + text + whole.substr(stop)));
    else
        EXPECT_EQ(whole.substr(start, stop - start), text)
            << "EDGESHADE_UPDATE_DOCS=1 in the environment writes " << file << " again";
}

} // namespace edgeshade::test
