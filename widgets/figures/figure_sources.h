// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>

#include "core/base/progress.h"
#include "core/geo/project_plane.h"
#include "widgets/figures/figure_recipe.h"
#include "widgets/figures/figure_run.h"

namespace nadir {

/// What a figure must know of a map beside its pictures.
struct MapFacts {
  Geodetic plane_origin;
  Eigen::AlignedBox2d bounds_in_enu_m;
  std::string hash;  ///< As RunHeader::map_hash.
};

/// Runs, maps and hashes for the figures of one command: each is opened, read and judged once, however many figures are
/// drawn of it. Files that change meanwhile are not noticed. One thread.
class FigureSources {
 public:
  /// @errors as open_figure_run.
  [[nodiscard]] Result<FigureRun> run(const std::filesystem::path& path,
                                      const FigureOptions& options);
  /// Reads all labels. @errors as read_overhead_map.
  [[nodiscard]] Result<MapFacts> map(const std::filesystem::path& package);
  /// FNV-1a of a file's bytes, hexadecimal, however large it is. @errors kNotFound, kIo; kCancelled.
  [[nodiscard]] Result<std::string> file_hash(const std::filesystem::path& path,
                                              const WorkContext& work);

 private:
  std::map<std::tuple<std::string, double, double>, FigureRun>
      runs_;  ///< By path, `from` and `to`.
  std::map<std::string, MapFacts> maps_;
  std::map<std::string, std::string> hashes_;
};

/// The file of a map package's picture, which may be missing.
[[nodiscard]] std::filesystem::path picture_of(const std::filesystem::path& map);

/// The map package that a recipe's figure is drawn on: the one that it names, else that of its first run. Empty where the
/// figure needs none. @errors as figure_kind, open_figure_run and find_map_of; kInvalidOptions: neither map nor run.
[[nodiscard]] Result<std::filesystem::path> map_of_recipe(const FigureRecipe& recipe,
                                                          FigureSources& sources);

/// Where a map package keeps the route that is drawn without being named.
[[nodiscard]] std::filesystem::path default_route_of(const std::filesystem::path& map);
/// The route file of figure 'route': the one that the recipe names, else the map's; empty for the other figures.
[[nodiscard]] std::filesystem::path route_of_recipe(const FigureRecipe& recipe,
                                                    const std::filesystem::path& map);

/// Hashes of what the recipe's figure is drawn from; see InputHashes. @errors as map_of_recipe and FigureSources.
[[nodiscard]] Result<InputHashes> hash_inputs(const FigureRecipe& recipe,
                                              FigureSources& sources,
                                              const WorkContext& work);

}  // namespace nadir
