// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace nadir {

/// How a run is to name what was given from the current folder: from the run's own folder, so that it is found from wherever
/// the run is opened. An absolute path stays.
[[nodiscard]] std::string name_from_run(const std::filesystem::path& run,
                                        const std::filesystem::path& given);

/// Where something that a run names lies now: where the run says, from its own folder or, as earlier runs meant it, from the
/// current one; else beside the run under the same name, for whoever moved both.
/// @param holding  A file that it must hold; empty where being there is enough.
[[nodiscard]] std::optional<std::filesystem::path> place_beside(
    const std::filesystem::path& run,
    const std::filesystem::path& named,
    const std::filesystem::path& holding = {});

}  // namespace nadir
