// Settings with different casters than the call's: the same as if they were the call's own, while
// the oracle still uses the surfaces.
#include "tests/support/packing.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

const std::string pavilion = std::string(EDGESHADE_ASSETS) + "/pavilion.glb";
const std::vector<std::string> settings = {"caster-error=0.05", "flat-tolerance=20",
                                           "weld-tolerance=0.02"};

Json reportOf(const std::string& verb, const std::string& file,
              const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {verb, file, "--size", "96x54", "--report", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = runEdgeshade(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(result.out);
}

std::vector<std::string> againstAll() {
    std::vector<std::string> words;
    for (const std::string& setting : settings)
        words.insert(words.end(), {"--against", setting});
    return words;
}

/// The pavilion, packed with this setting.
std::string packedWith(const TempFolder& folder, const std::string& setting) {
    const std::string file = folder / (setting + ".glb");
    const std::size_t equals = setting.find('=');
    const ProcessResult result = runEdgeshade(
        {"pack", pavilion, file, "--" + setting.substr(0, equals), setting.substr(equals + 1)});
    EXPECT_EQ(result.status, 0) << result.err;
    return file;
}

} // namespace

TEST(CoarserCasters, BenchMeasuresThemAsItMeasuresAFilePackedWithThem) {
    const TempFolder folder;
    std::vector<std::string> words = againstAll();
    words.insert(words.end(), {"--frames", "2"});
    const Json all = reportOf("bench", pavilion, words);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        SCOPED_TRACE(settings[i]);
        const Json& exact = all["results"][0];
        const Json& coarse = all["results"][i + 1];
        const Json alone = reportOf("bench", packedWith(folder, settings[i]), {"--frames", "2"});
        EXPECT_NE(coarse["vertex_runs"], exact["vertex_runs"]);
        EXPECT_EQ(coarse["vertex_runs"], alone["vertex_runs"]);
        EXPECT_EQ(coarse["bytes_gpu"], alone["bytes_gpu"]);
        EXPECT_EQ(coarse["settings"], alone["settings"]);
        const std::string key = settings[i].substr(0, settings[i].find('='));
        EXPECT_EQ(exact["settings"][key], 0.0);
        EXPECT_GT(coarse["settings"][key], 0.0);
    }
}

TEST(CoarserCasters, CompareAsksTheOracleOfTheSurfaces) {
    const TempFolder folder;
    std::vector<std::string> words = againstAll();
    words.insert(words.end(), {"--views", "2"});
    const Json all = reportOf("compare", pavilion, words);
    const Json exact = reportOf("compare", pavilion, {"--views", "2"});
    EXPECT_EQ(all["results"][0]["wrong_image_pixels"], exact["wrong_image_pixels"]);
    EXPECT_GT(all["results"][1]["wrong_image_pixels"], exact["wrong_image_pixels"]);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        SCOPED_TRACE(settings[i]);
        const Json& coarse = all["results"][i + 1];
        // A weld tolerance moves the geometry that the oracle of the packed file sees; the other
        // settings don't.
        if (settings[i].starts_with("weld")) continue;
        const Json alone = reportOf("compare", packedWith(folder, settings[i]), {"--views", "2"});
        for (const char* key : {"visible_pixels", "wrong_mask_pixels", "wrong_image_pixels"})
            EXPECT_EQ(coarse[key], alone[key]) << key;
    }
}

} // namespace edgeshade::test
