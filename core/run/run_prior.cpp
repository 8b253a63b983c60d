// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_prior.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <system_error>

namespace nadir {
namespace fs = std::filesystem;
namespace {

constexpr const char* kTruthWords = "truth of the first frame";
constexpr const char* kGlobalWord = "global";

/// The run that another one goes on from; nothing where it is not there.
std::optional<fs::path> parent_of(const fs::path& run, const fs::path& named) {
  for (const fs::path& candidate : {run.parent_path() / named.filename(), named}) {
    std::error_code error;
    if (!fs::exists(candidate, error)) continue;
    if (!fs::equivalent(candidate, run, error)) return candidate;
  }
  return std::nullopt;
}

}  // namespace

std::string prior_text(const std::optional<Prior>& prior) {
  if (!prior) return kTruthWords;
  const auto* gaussian = std::get_if<GaussianPrior>(&*prior);
  if (gaussian == nullptr) return kGlobalWord;
  return fmt::format("{} m east, {} m north, yaw {} rad; sigma {} m, {} rad",
                     gaussian->mean_in_enu.x_m, gaussian->mean_in_enu.y_m,
                     gaussian->mean_in_enu.yaw_rad, gaussian->position_sigma_m,
                     gaussian->yaw_sigma_rad);
}

Result<std::optional<Prior>> parse_prior_text(const std::string& text) {
  if (text == kTruthWords) return std::optional<Prior>();
  if (text == kGlobalWord) return std::optional<Prior>(GlobalPrior{});
  std::array<double, 5> read{};
  int end = -1;
  std::sscanf(text.c_str(), "%lf m east, %lf m north, yaw %lf rad; sigma %lf m, %lf rad%n",
              &read[0], &read[1], &read[2], &read[3], &read[4], &end);
  const bool is_whole = end == static_cast<int>(text.size()) && std::isfinite(read[0]) &&
                        std::isfinite(read[1]) && std::isfinite(read[2]) && read[3] >= 0.0 &&
                        read[4] >= 0.0;
  if (!is_whole) return fail(ErrorCode::kMalformed, "prior '{}' is none that can be read", text);
  return std::optional<Prior>(GaussianPrior{.mean_in_enu = {read[0], read[1], read[2]},
                                            .position_sigma_m = read[3],
                                            .yaw_sigma_rad = read[4]});
}

Result<std::optional<Prior>> recorded_prior(const fs::path& run, const RunHeader& header) {
  constexpr int kMostParents = 100;  // runs that name each other in a circle have an end too
  fs::path at = run;
  RunHeader now = header;
  for (int i = 0; i < kMostParents && !now.parent_run.empty(); ++i) {
    const auto parent = parent_of(at, now.parent_run);
    if (!parent) {
      return fail(ErrorCode::kNotFound,
                  "{}: goes on from {}, which is not there, so how its flight began is not known",
                  at.string(), now.parent_run);
    }
    const auto reader = RunReader::open(*parent);
    if (!reader) return forward_error(reader);
    if (reader->header().flight_hash != header.flight_hash) {
      return fail(ErrorCode::kNotFound,
                  "{}: goes on from {}, and {} is of another flight now, so how its flight began "
                  "is not known",
                  at.string(), now.parent_run, parent->string());
    }
    at = *parent;
    now = reader->header();
  }
  const auto text = now.options.find(kPriorOption);
  if (text == now.options.end() || !now.parent_run.empty()) {
    return fail(ErrorCode::kMalformed, "{}: does not say how its flight began", at.string());
  }
  auto prior = parse_prior_text(text->second);
  if (!prior) return forward_error(prior, at.string());
  return prior;
}

}  // namespace nadir
