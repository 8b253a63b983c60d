// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/mcl/prior.h"
#include "core/run/run_file.h"

namespace nadir {

/// The option of a run's header that says how the run began.
inline constexpr const char* kPriorOption = "prior";

/// How a run begins, as text for its header. Lengths in metres, angles in radians, each to its last bit.
/// @param prior  Without one: at the truth of the first frame.
[[nodiscard]] std::string prior_text(const std::optional<Prior>& prior);

/// What prior_text() has written; nothing for the truth of the first frame. @errors kMalformed.
[[nodiscard]] Result<std::optional<Prior>> parse_prior_text(const std::string& text);

/// The prior with which the flight of a recorded run was begun, so that it can be run again from its start. A run that goes
/// on from another began as that one did: it is looked for beside the run, then where the run says.
/// @param run  File that the header is of.
/// @returns nothing for the truth of the first frame.
/// @errors kMalformed: the header does not say it, or in words that are none; kNotFound: a run that it goes on from is not
/// there, or is of another flight; as RunReader::open of such a run.
[[nodiscard]] Result<std::optional<Prior>> recorded_prior(const std::filesystem::path& run,
                                                          const RunHeader& header);

}  // namespace nadir
