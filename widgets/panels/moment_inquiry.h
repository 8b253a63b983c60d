// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/map/map_index.h"
#include "core/run/run_options.h"
#include "core/session/moment_explanation.h"
#include "core/session/moment_surface.h"

namespace nadir {

/// What "why here?" asks about: one step of a run on a map, with the options that the run was made with.
struct MomentQuestion {
  std::shared_ptr<const RunStep> step;  ///< With its topview.
  std::shared_ptr<const MapIndex> map;
  RunOptions options;
  std::string options_key;   ///< The same for the same options.
  bool with_surface = true;  ///< The error surface costs about 100 ms, the rest a few.
};

/// What came of it. Immutable.
struct MomentAnswer {
  std::shared_ptr<const RunStep> step;
  std::shared_ptr<const MapIndex> map;
  bool has_tried_surface = false;
  std::optional<MomentExplanation> explanation;
  std::string words;   ///< in_words() of it.
  std::string surety;  ///< surety_in_words() of it.
  std::optional<MomentSurface> surface;
  std::string hold_words;  ///< in_words() of the surface's place_hold(); empty without a surface.
  std::string error;  ///< Why there is no explanation, or else no surface; empty: nothing failed.
};

/// Answers such questions in a thread of its own, the newest first; nobody waits. What matching needs of a map is made once
/// and kept until map or options change. All calls from one thread.
class MomentInquiry {
 public:
  MomentInquiry();
  ~MomentInquiry();  ///< Waits for at most the one step of the question that is being worked on.
  MomentInquiry(const MomentInquiry&) = delete;
  MomentInquiry& operator=(const MomentInquiry&) = delete;

  /// The same question again costs nothing. A question with a part missing is not asked.
  void ask(const MomentQuestion& question);
  /// The newest answer, perhaps to an older question: compare its step. Null before the first.
  [[nodiscard]] std::shared_ptr<const MomentAnswer> answer() const;
  [[nodiscard]] bool is_working() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Answers at once, on this thread. @param matcher  Of the question's map and options.
[[nodiscard]] MomentAnswer answer_moment(const MomentQuestion& question, const MapMatcher& matcher);

/// The options that a run was made with, from its header; what this version does not know is passed over.
[[nodiscard]] RunOptions options_of(const RunHeader& header);

}  // namespace nadir
