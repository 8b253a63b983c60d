// SPDX-License-Identifier: Apache-2.0
#include "core/run/place_beside.h"

#include <system_error>

namespace nadir {
namespace fs = std::filesystem;

std::string name_from_run(const fs::path& run, const fs::path& given) {
  if (given.empty() || given.is_absolute()) return given.string();
  std::error_code error;
  const fs::path named = fs::relative(given, fs::absolute(run, error).parent_path(), error);
  return error || named.empty() ? given.string() : named.string();
}

std::optional<fs::path> place_beside(const fs::path& run,
                                     const fs::path& named,
                                     const fs::path& holding) {
  const fs::path last = named.has_filename() ? named.filename() : named.parent_path().filename();
  if (last.empty()) return std::nullopt;
  std::error_code error;
  for (const fs::path& candidate : {run.parent_path() / named, named, run.parent_path() / last}) {
    if (fs::exists(holding.empty() ? candidate : candidate / holding, error)) return candidate;
  }
  return std::nullopt;
}

}  // namespace nadir
