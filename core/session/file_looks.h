// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace nadir {

/// What a file seems to be, told by its first bytes and not by its name, in words that follow "is": "a JPEG picture", "a text",
/// "empty". Reads at most a few hundred bytes.
[[nodiscard]] std::string looks_of_file(const std::filesystem::path& file);

}  // namespace nadir
