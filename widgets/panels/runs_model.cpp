// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/session/session.h"
#include "widgets/panels/panel_text.h"
#include "widgets/panels/runs_panel.h"

namespace nadir {
namespace {

/// The job that writes a live run: the one that speaks of it, else the first that localises.
const JobStatus* job_of(const std::vector<JobStatus>& jobs, const OpenRun& run) {
  const auto has = [](const JobStatus& job, const std::string& words) {
    return job.title.find(words) != std::string::npos;
  };
  const auto named = std::find_if(jobs.begin(), jobs.end(), [&](const JobStatus& job) {
    return has(job, "ocalising") && has(job, run.name);
  });
  if (named != jobs.end()) return &*named;
  const auto any = std::find_if(jobs.begin(), jobs.end(),
                                [&](const JobStatus& job) { return has(job, "ocalising"); });
  return any == jobs.end() ? nullptr : &*any;
}

/// Of the active run, whose flight alone the session hands out.
double flight_end_s(const Session& session, const RunDocument& run) {
  const auto flight = session.flight();
  if (flight == nullptr || flight->description().frames.empty() || run.steps.empty()) return 0.0;
  return flight->description().frames.back().time_s - run.start_clock_s;
}

}  // namespace

RunsModel runs_model(const Session& session) {
  RunsModel model;
  const ViewState& view = session.view();
  model.is_split = view.map.is_split;
  const std::vector<JobStatus> jobs = session.jobs();
  for (std::size_t i = 0; i < session.runs().size(); ++i) {
    const OpenRun& run = session.runs()[i];
    RunsModel::Row row;
    row.number = static_cast<int>(i) + 1;
    row.name = run.name;
    row.path = run.path.string();
    row.colour = view.runs[i].colour;
    row.is_active = view.active_run == row.number;
    row.is_shown = view.runs[i].is_shown;
    row.is_live = run.is_live;
    row.document = run.document;
    if (const JobStatus* const job = run.is_live ? job_of(jobs, run) : nullptr) {
      row.job = job->number;
      row.progress = job->fraction;
      row.progress_words = job->left_s ? left_text(*job->left_s) : job->activity;
    }
    row.flight_end_s = row.is_active && run.document ? flight_end_s(session, *run.document) : 0.0;
    model.rows.push_back(std::move(row));
  }
  return model;
}

}  // namespace nadir
