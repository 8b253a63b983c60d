// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/topview/semantic_cloud.h"

namespace nadir {

/// Saves a cloud as binary PCD or PLY, by the file's ending: x y z in metres (`level`) and `label`,
/// as PCL's PointXYZL.
/// @errors kUnsupported (another ending), kIo.
[[nodiscard]] Result<void> write_semantic_cloud(const SemanticCloud& cloud,
                                                const std::filesystem::path& path);

/// Loads what write_semantic_cloud saves, or any PCD or PLY with x, y, z and label. Labels that are
/// no class become kUnclassified. @errors kNotFound, kMalformed, kUnsupported.
[[nodiscard]] Result<SemanticCloud> read_semantic_cloud(const std::filesystem::path& path);

/// Removes points with fewer than `min_neighbours` others within `radius_m` (flying pixels at depth
/// edges).
[[nodiscard]] SemanticCloud without_outliers(const SemanticCloud& cloud,
                                             double radius_m,
                                             int min_neighbours);

}  // namespace nadir
