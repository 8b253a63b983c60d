// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/session/run_comparison.h"
#include "core/session/view_state.h"

namespace nadir {

/// A name as wide as there is room: with "…" in the middle where it is wider, for names of runs differ at their ends. At least
/// three characters stay.
/// @param width_of  Of a line of text, in the unit of `room`.
[[nodiscard]] std::string fitted_name(const std::string& name,
                                      double room,
                                      const std::function<double(const std::string&)>& width_of);

/// Names without what all of them begin and end with, which "…" stands for: "loop-1.5-a" and "loop-2-a" are "…1.5…" and "…2…". Cut
/// only between words, and only where that leaves something of each and makes it shorter.
[[nodiscard]] std::vector<std::string> told_apart(std::span<const std::string> names);

/// Number of the active run's colour, of run_colour(); 0 where no run is open.
[[nodiscard]] std::size_t active_colour(const ViewState& view);

/// Whether a run ended before its end: it was stopped or killed, or another program is still writing it.
/// @param is_live  This program is writing it.
[[nodiscard]] bool is_incomplete(const RunDocument& run, bool is_live);

/// "stopped at 00:43.0 of 01:40.0, after 430 steps".
/// @param flight_end_s  Last frame of the flight after the run's first step; not above 0: not known.
[[nodiscard]] std::string incomplete_words(const RunDocument& run, double flight_end_s = 0.0);

/// Which part of the flight the numbers of a comparison are over: "Over 00:00.0 to 00:43.0, which all of these runs cover: loop-2
/// ends there". Times are the first run's.
/// A run that is still being made has come to where it ends now: "loop-2 has come that far".
/// @param names  Of the runs, in the order of the comparison. @param live  Those of them that this program is making, by name.
[[nodiscard]] std::string span_words(const RunComparison& comparison,
                                     std::span<const std::string> names,
                                     const std::set<std::string>& live = {});

/// Which of the runs are the same up to where one went on from the other: "Up to 01:20.0 loop-2 has its steps from loop". Empty: none.
/// @param runs  As compared. @param names  Of them.
[[nodiscard]] std::string copied_words(RunDocuments runs, std::span<const std::string> names);

}  // namespace nadir
