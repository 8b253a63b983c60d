// SPDX-License-Identifier: Apache-2.0
// Maps and flights on their way from the disk, and which of them belong to a run.
#include <algorithm>
#include <system_error>

#include "core/run/place_beside.h"
#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

Result<ReadMap> read_map_for_window(const fs::path& package, const WorkContext& context) {
  context.report(0.0, "reading the map");
  auto provenance = read_map_provenance(package);
  if (!provenance) return forward_error(provenance);
  auto labels = read_overhead_map(package);
  if (!labels) return forward_error(labels);
  if (context.is_stopped()) return fail(ErrorCode::kCancelled, "reading the map was stopped");
  return ReadMap{
      std::move(*provenance),
      std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(*labels)))};
}

/// The map package that a run was made on: where it says, beside it, or the bundled one of that name.
std::optional<fs::path> map_of_run(const RunDocument& run, const fs::path& bundled) {
  const fs::path named = run.header.map_path;
  if (auto place = place_beside(run.path, named, "map.toml")) return place;
  std::error_code error;
  const bool is_bundled = named.filename() == bundled.filename() && !bundled.empty();
  if (is_bundled && fs::exists(bundled / "map.toml", error)) return bundled;
  return std::nullopt;
}

}  // namespace

void Session::Implementation::reconcile_map() {
  const std::string map_path = map ? map->path.string() : std::string();
  if (kept.view.map_path != map_path) {
    let_go(map_reading);
    map.reset();
    if (!kept.view.map_path.empty()) {
      map = OpenMap{kept.view.map_path, {}, nullptr};
      map_reading.emplace([path = map->path](const WorkContext& context, const auto& /*publish*/) {
        return read_map_for_window(path, context);
      });
    }
  }
}

void Session::Implementation::find_inputs(std::size_t index) {
  const std::shared_ptr<const RunDocument> document = runs[index].document;
  const std::string path = runs[index].path.string();
  const fs::path flight_named = document->header.flight_path;
  if (const auto flight_there = place_beside(document->path, flight_named)) {
    works[index].flight_path = absolute_path(*flight_there);
    begin_flight(works[index].flight_path);
  } else {
    add_notice(Notice::Kind::kWarning,
               fmt::format("{}: its flight {} is not there, so what the camera saw cannot be shown",
                           path, flight_named.string()));
  }
  const auto map_there = map_of_run(*document, places.bundled_map);
  if (map_there) works[index].map_path = absolute_path(*map_there);
  if (!map_there) {
    if (kept.view.map_path.empty()) {
      add_notice(Notice::Kind::kWarning,
                 fmt::format("{}: its map {} is not there; open the map's folder to see it", path,
                             document->header.map_path));
    }
  } else {
    // It belongs to the opening of the run, so states since then get it too.
    const std::string map_path = works[index].map_path;
    const std::string map_before = kept.view.map_path;
    const OpenRun* const run = active();
    const bool is_active = run != nullptr && run->path.string() == path;
    if (is_active && map_before != map_path) {
      amend([&](KeptState& state) {
        const auto number = static_cast<std::size_t>(state.view.active_run);
        if (number == 0 || number > state.view.runs.size()) return;
        if (state.view.runs[number - 1].path != path || state.view.map_path != map_before) return;
        state.view.map_path = map_path;
        if (!map_before.empty()) state.view.map.width_m = 0.0;
      });
    }
  }
  reconcile();
}

void Session::Implementation::begin_flight(const std::string& path) {
  FlightWork& work = flights[path];
  if (work.recording || work.reading || work.has_failed) return;
  work.reading.emplace(
      [path](const WorkContext& /*context*/,
             const auto& /*publish*/) -> Result<std::shared_ptr<const FlightRecording>> {
        auto opened = open_flight(path);
        if (!opened) return forward_error(opened);
        return std::shared_ptr<const FlightRecording>(std::move(*opened));
      });
}

void Session::Implementation::take_flights() {
  for (auto& [path, work] : flights) {
    if (!work.reading || !work.reading->is_done()) continue;
    auto read = std::move(*work.reading->outcome());
    work.reading.reset();
    if (!read) {
      work.has_failed = true;
      const bool was_opened = kept.view.flight_path == path;
      add_notice(was_opened ? Notice::Kind::kError : Notice::Kind::kWarning, read.error().message);
      amend([flight_path = path](KeptState& state) {
        if (state.view.flight_path == flight_path) state.view.flight_path.clear();
      });
      continue;
    }
    work.recording = std::move(*read);
    if (kept.view.flight_path == path) remember(path);
  }
  // One that failed may be there when it is asked for again.
  std::erase_if(flights, [this](const auto& flight) {
    const auto& path = flight.first;
    const bool is_used = path == kept.view.flight_path ||
                         std::any_of(works.begin(), works.end(), [&path](const RunWork& work) {
                           return work.flight_path == path;
                         });
    return !is_used && !flight.second.reading;
  });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto found = flights.find(works[i].flight_path);
    if (runs[i].cache && found != flights.end()) runs[i].cache->set_flight(found->second.recording);
  }
}

void Session::Implementation::take_map() {
  if (!map_reading || !map_reading->is_done()) return;
  auto read = std::move(*map_reading->outcome());
  map_reading.reset();
  if (read) {
    map->provenance = std::move(read->provenance);
    map->index = std::move(read->index);
    last_good_map = map->path.string();
    remember(last_good_map);
    return;
  }
  add_notice(Notice::Kind::kError, read.error().message);
  const std::string path = map->path.string();
  std::erase(recents, path);
  const std::string instead = last_good_map == path ? std::string() : last_good_map;
  amend([&](KeptState& state) {
    if (state.view.map_path == path) state.view.map_path = instead;
  });
  reconcile();
}

std::shared_ptr<const FlightRecording> Session::Implementation::flight() const {
  std::string path;
  const OpenRun* const run = active();
  if (run != nullptr) path = works[static_cast<std::size_t>(run - runs.data())].flight_path;
  auto found = flights.find(path);
  if (path.empty() || found == flights.end() || !found->second.recording) {
    found = flights.find(kept.view.flight_path);
  }
  return found != flights.end() ? found->second.recording : nullptr;
}

}  // namespace nadir
