// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_sources.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/base/hash.h"
#include "core/map/overhead_map_file.h"
#include "widgets/figures/figures.h"

namespace nadir {
namespace fs = std::filesystem;

Result<FigureRun> FigureSources::run(const fs::path& path, const FigureOptions& options) {
  const std::tuple key(path.string(), options.from_s, options.to_s);
  if (const auto known = runs_.find(key); known != runs_.end()) return known->second;
  auto run = open_figure_run(path, options);
  if (run) runs_.emplace(key, *run);
  return run;
}

Result<MapFacts> FigureSources::map(const fs::path& package) {
  if (const auto known = maps_.find(package.string()); known != maps_.end()) return known->second;
  const auto map = read_overhead_map(package);
  if (!map) return forward_error(map);
  const Eigen::Vector2d top_left = map->top_left_in_enu_m;
  const MapFacts facts{map->plane.origin(),
                       {Eigen::Vector2d(top_left.x(), top_left.y() - map->height_m()),
                        Eigen::Vector2d(top_left.x() + map->width_m(), top_left.y())},
                       content_hash(*map)};
  return maps_.emplace(package.string(), facts).first->second;
}

Result<std::string> FigureSources::file_hash(const fs::path& path, const WorkContext& work) {
  if (const auto known = hashes_.find(path.string()); known != hashes_.end()) return known->second;
  std::error_code error;
  if (!fs::exists(path, error)) {
    return fail(ErrorCode::kNotFound, "{}: does not exist", path.string());
  }
  std::ifstream stream(path, std::ios::binary);
  Hash hash;
  std::array<char, 65536> chunk;
  while (stream.read(chunk.data(), chunk.size()) || stream.gcount() > 0) {
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "{}: was stopped", path.string());
    hash.add(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.eof()) {
    return fail(ErrorCode::kIo, "{}: {}", path.string(), std::generic_category().message(errno));
  }
  return hashes_.emplace(path.string(), hash.text()).first->second;
}

Result<fs::path> map_of_recipe(const FigureRecipe& recipe, FigureSources& sources) {
  const auto kind = figure_kind(recipe.figure);
  if (!kind) return forward_error(kind);
  if (!kind->needs_map) return fs::path();
  if (!recipe.map.empty()) return fs::path(recipe.map);
  if (recipe.runs.empty()) {
    return fail(ErrorCode::kInvalidOptions, "figure '{}' needs a map (--map FOLDER)", kind->name);
  }
  const auto run = sources.run(recipe.runs.front(), recipe.options);
  if (!run) return forward_error(run);
  return find_map_of(*run);
}

fs::path picture_of(const fs::path& map) { return map / "image.tif"; }

fs::path default_route_of(const fs::path& map) { return map / "routes" / "loop.toml"; }

fs::path route_of_recipe(const FigureRecipe& recipe, const fs::path& map) {
  if (recipe.figure != "route") return {};
  return recipe.route.empty() ? default_route_of(map) : fs::path(recipe.route);
}

Result<InputHashes> hash_inputs(const FigureRecipe& recipe,
                                FigureSources& sources,
                                const WorkContext& work) {
  InputHashes hashes;
  for (const std::string& run : recipe.runs) {
    const auto hash = sources.file_hash(run, work);
    if (!hash) return forward_error(hash);
    hashes.runs.push_back(*hash);
  }
  const auto map = map_of_recipe(recipe, sources);
  if (!map) return forward_error(map);
  if (map->empty()) return hashes;
  const auto facts = sources.map(*map);
  if (!facts) return forward_error(facts);
  hashes.map = facts->hash;
  std::error_code error;
  const fs::path picture = picture_of(*map);
  if (shows_picture(recipe) && fs::exists(picture, error)) {
    const auto hash = sources.file_hash(picture, work);
    if (!hash) return forward_error(hash);
    hashes.picture = *hash;
  }
  const fs::path route = route_of_recipe(recipe, *map);
  if (route.empty()) return hashes;
  const auto hash = sources.file_hash(route, work);
  if (!hash) return forward_error(hash);
  hashes.route = *hash;
  return hashes;
}

}  // namespace nadir
