#include "src/city/text_by_source.hpp"

#include "preprocess/base/error.hpp"

namespace edgeshade::city {
namespace {

void require(const std::ios& stream, const std::filesystem::path& path) {
    if (!stream) throw Error(ExitStatus::output, "'" + path.string() + "' can't be written.");
}

} // namespace

TextBySource::TextBySource(const std::filesystem::path& path, std::size_t sources)
    : path_(path), file_(path, std::ios::in | std::ios::out | std::ios::binary | std::ios::trunc),
      places_(sources) {
    require(file_, path_);
}

void TextBySource::add(std::size_t source, std::string_view text) {
    places_[source] = {file_.tellp(), text.size()};
    file_.write(text.data(), static_cast<std::streamsize>(text.size()));
    require(file_, path_);
}

void TextBySource::write(const std::filesystem::path& path, std::string_view header) {
    std::ofstream all(path, std::ios::binary);
    all << header;
    std::string text;
    for (const Place& place : places_) {
        text.resize(place.size);
        file_.seekg(place.begin);
        file_.read(text.data(), static_cast<std::streamsize>(text.size()));
        require(file_, path_);
        all << text;
    }
    all.flush();
    require(all, path);
}

} // namespace edgeshade::city
