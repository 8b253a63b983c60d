// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace nadir {

/// Checks that a PCD or PLY file (by its ending) has a whole header and as many bytes as the header
/// promises. PCL's own readers crash on files that are cut short, so nothing reaches them
/// unchecked.
/// @errors kNotFound, kMalformed, kUnsupported (more than 2^28 points, other endings).
[[nodiscard]] Result<void> check_point_file(const std::filesystem::path& path);

}  // namespace nadir
