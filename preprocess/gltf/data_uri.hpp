#pragma once

#include "preprocess/base/file_io.hpp"

#include <string>
#include <string_view>

namespace edgeshade {

/// Whether the uri is a data URI (RFC 2397).
bool isDataUri(std::string_view uri);

/// The bytes of a data URI, with any media type or none: base64, or percent-encoded without
/// ";base64". In base64, white space is skipped, padding may be missing, and both may be
/// percent-encoded. Throws an InputError that starts with `where`, the file and the field.
Bytes dataOfUri(std::string_view uri, const std::string& where);

} // namespace edgeshade
