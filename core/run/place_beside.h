// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace nadir {

/// Where something that a run names lies now: where the run says, else beside the run under the same name, for whoever moved
/// both. @param holding  A file that it must hold; empty where being there is enough.
[[nodiscard]] std::optional<std::filesystem::path> place_beside(
    const std::filesystem::path& run,
    const std::filesystem::path& named,
    const std::filesystem::path& holding = {});

}  // namespace nadir
