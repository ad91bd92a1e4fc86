#pragma once

#include "preprocess/base/file_io.hpp"

#include <string>
#include <string_view>

namespace edgeshade {

/// Whether the uri is a data URI (RFC 2397).
bool isDataUri(std::string_view uri);

/// The bytes of a data URI of whatever media type, also of none: base64, or percent-encoded where
/// it does not say ";base64". White space in base64 is passed over, padding may be missing, and
/// either may itself be percent-encoded. Throws an InputError that starts with `where`, the file
/// and the field.
Bytes dataOfUri(std::string_view uri, const std::string& where);

} // namespace edgeshade
