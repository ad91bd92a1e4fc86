#include "src/cli/limit_options.hpp"

#include <charconv>
#include <limits>
#include <string_view>

namespace edgeshade::cli {
namespace {

/// Parses a whole number above 0. Numbers of bytes may end in K, M or G for powers of 1024.
std::uint64_t limitFrom(const std::string& text, const std::string& option, bool isBytes) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto number = std::from_chars(text.data(), end, value);
    const std::string_view unit(number.ptr, static_cast<std::size_t>(end - number.ptr));
    constexpr std::string_view units("KMG");
    const std::size_t power = unit.empty() ? 0 : units.find(unit) + 1; // 0: no such unit
    const bool isUnit = unit.empty() || (isBytes && unit.size() == 1 && power > 0);
    if (number.ec != std::errc() || !isUnit || value == 0 ||
        value > std::numeric_limits<std::uint64_t>::max() >> 10 * power)
        throw CLI::ValidationError(option, "'" + text + "' is no whole number above 0" +
                                               (isBytes ? ", with or without K, M or G" : ""));
    return value << 10 * power;
}

std::string shown(std::uint64_t value, bool isBytes) {
    return isBytes ? std::to_string(value >> 30) + "G" : std::to_string(value);
}

} // namespace

void addLimitOptions(CLI::App& verb, ReadingLimits& limits) {
    const auto add = [&](const std::string& option, std::uint64_t& limit, bool isBytes,
                         const std::string& help) {
        verb.add_option_function<std::string>(
                option,
                [&limit, option, isBytes](const std::string& text) {
                    limit = limitFrom(text, option, isBytes);
                },
                help + " (" + shown(limit, isBytes) + ")")
            ->type_name(isBytes ? "BYTES" : "N")
            ->group("Limits of what is read");
    };
    add("--max-file", limits.fileBytes, true,
        "Refuse larger files, the scene's own or one that it names; K, M, G are powers of 1024");
    add("--max-memory", limits.memoryBytes, true,
        "Refuse scenes of which reading makes more: files, JSON, what is decompressed, vertices "
        "once for every node that uses them, pictures");
    add("--max-triangles", limits.triangles, false,
        "Refuse scenes of more triangles, each counted for every node that uses it");
    add("--max-nodes", limits.nodes, false, "Refuse scenes of more nodes");
    add("--max-node-depth", limits.nodeDepth, false, "Refuse scenes of more levels of nodes");
}

} // namespace edgeshade::cli
