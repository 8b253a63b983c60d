// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "widgets/panels/run_labels.h"
#include "widgets/panels/why_panel.h"

namespace nadir {

namespace {

/// What the timeline marks at a step; of several the most severe.
std::optional<WorstMoment> mark_of(const OpenRun& run, int step) {
  std::optional<WorstMoment> mark;
  for (const WorstMoment& moment : run.moments) {
    const bool is_here =
        moment.step < run.document->steps.size() && run.document->steps[moment.step].step == step;
    if (is_here && (!mark || moment.severity > mark->severity)) mark = moment;
  }
  return mark;
}

}  // namespace

WhyModel why_model(const Session& session, MomentInquiry& inquiry) {
  WhyModel model;
  const OpenRun* const run = session.active_run();
  const OpenMap* const map = session.map();
  model.has_map = map != nullptr;
  if (run == nullptr) return model;
  model.run_name = run->name;
  model.colour = active_colour(session.view());
  model.is_reading = !run->document || (map != nullptr && !map->index);
  model.has_step = session.step_index().has_value();
  model.is_playing = session.playback().is_playing;
  if (!run->document || map == nullptr || !map->index) return model;
  const auto step = session.step();
  if (step) {
    MomentQuestion question;
    question.step = step;
    question.map = map->index;
    question.options = options_of(run->document->header);
    for (const auto& [name, text] : run->document->header.options) {
      question.options_key += fmt::format("{}={}\n", name, text);
    }
    question.with_surface = !model.is_playing;
    inquiry.ask(question);
  }
  model.answer = inquiry.answer();
  model.is_computing = inquiry.is_working() || !step;
  model.is_answer_of_now = model.answer && step && model.answer->step == step;
  if (model.is_answer_of_now) {
    model.mark = mark_of(*run, model.answer->step->step);
  }
  return model;
}

VerdictHead verdict_head(MomentVerdict verdict, const std::optional<WorstMoment>& mark) {
  using kit::TextLook;
  switch (verdict) {
    case MomentVerdict::kNoEvidence:
      return {"Nothing to compare", TextLook::kWarning};
    case MomentVerdict::kNoTruth:
      return {"The truth is not known", TextLook::kNormal};
    case MomentVerdict::kFound:
      if (mark && mark->kind != MomentKind::kFound) {
        return {"Near the truth, but worth a look", TextLook::kWarning};
      }
      return {"Near the truth", TextLook::kGood};
    case MomentVerdict::kTruthFitsBetter:
      return {"Missed: the truth fits better", TextLook::kBad};
    case MomentVerdict::kMapMisleads:
      return {"Misled: here the estimate fits better", TextLook::kBad};
    case MomentVerdict::kBothFitAlike:
      return {"Both places look alike", TextLook::kWarning};
  }
  return {};
}

}  // namespace nadir
