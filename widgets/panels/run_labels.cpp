// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_labels.h"

#include <fmt/format.h>

#include <algorithm>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/time_axis.h"

namespace nadir {

std::string fitted_name(const std::string& name,
                        double room,
                        const std::function<double(const std::string&)>& width_of) {
  if (width_of(name) <= room) return name;
  constexpr std::size_t kLeastCharacters = 3;
  std::size_t least = kLeastCharacters;
  std::size_t most = std::max(kLeastCharacters, name.size());
  while (least < most) {  // the most characters that fit
    const std::size_t middle = (least + most + 1) / 2;
    if (width_of(shortened(name, middle)) <= room) {
      least = middle;
    } else {
      most = middle - 1;
    }
  }
  return shortened(name, least);
}

bool is_incomplete(const RunDocument& run, bool is_live) {
  return !is_live && !run.is_complete && !run.steps.empty();
}

std::string incomplete_words(const RunDocument& run, double flight_end_s) {
  const std::string of = flight_end_s > run.duration_s() ? " of " + clock_text(flight_end_s) : "";
  return fmt::format("stopped at {}{}, after {} {}", clock_text(run.duration_s()), of,
                     run.steps.size(), run.steps.size() == 1 ? "step" : "steps");
}

}  // namespace nadir
