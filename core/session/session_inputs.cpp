// SPDX-License-Identifier: Apache-2.0
// Maps and flights on their way from the disk, and which of them belong to a run.
#include <algorithm>
#include <system_error>

#include "core/run/localise_flight.h"
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
  std::string hash = content_hash(*labels);
  return ReadMap{
      std::move(*provenance),
      std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(*labels))),
      std::move(hash)};
}

bool holds_map(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "map.toml", error);
}

/// Map packages in a folder, by name.
std::vector<std::string> maps_in(const fs::path& folder, const WorkContext& context) {
  constexpr std::size_t kMostNames = 1000;  // of a folder with more nobody knows what it is for
  std::vector<std::string> maps;
  std::error_code error;
  std::size_t seen = 0;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (context.is_stopped() || ++seen > kMostNames) break;
    std::error_code gone;
    if (at->is_directory(gone) && holds_map(at->path())) maps.push_back(at->path().string());
  }
  std::sort(maps.begin(), maps.end());
  return maps;
}

/// What a flight may have been flown over: maps in its folder and beside it, then those that were opened before.
std::vector<std::string> maps_of_flight(const fs::path& flight,
                                        const std::vector<std::string>& opened,
                                        const WorkContext& context) {
  constexpr std::size_t kMostMaps = 4;
  std::error_code error;
  std::vector<std::string> maps;
  const auto add = [&maps](const std::vector<std::string>& more) {
    for (const std::string& map : more) {
      const bool is_known = std::find(maps.begin(), maps.end(), map) != maps.end();
      if (!is_known && maps.size() < kMostMaps) maps.push_back(map);
    }
  };
  if (fs::is_directory(flight, error)) add(maps_in(flight, context));
  add(maps_in(flight.parent_path(), context));
  for (const std::string& path : opened) {
    if (holds_map(path)) add({path});
  }
  return maps;
}

/// Whether a flight has all that localising it takes.
bool can_be_localised(const FlightDescription& flight) {
  return flight.camera && flight.odometry &&
         std::any_of(flight.frames.begin(), flight.frames.end(),
                     [](const FlightFrame& frame) { return frame.labels.has_value(); });
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
      map = OpenMap{kept.view.map_path, {}, nullptr, {}};
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
  // One that was opened by itself may be the run's, moved.
  const auto opened = flights.find(kept.view.flight_path);
  const bool is_opened_one = opened != flights.end() && !opened->second.hash.empty() &&
                             opened->second.hash == document->header.flight_hash;
  if (const auto flight_there = place_beside(document->path, flight_named)) {
    works[index].flight_path = absolute_path(*flight_there);
    begin_flight(works[index].flight_path);
  } else if (is_opened_one) {
    works[index].flight_path = opened->first;
  } else {
    add_notice(Notice::Kind::kWarning,
               fmt::format("{}: its flight {} is not there, so what the camera saw cannot be shown",
                           path, flight_named.string()));
  }
  if (const auto map_there = map_of_run(*document, places.bundled_map)) {
    works[index].map_path = absolute_path(*map_there);
    take_map_of(index);
  } else if (kept.view.map_path.empty()) {
    add_notice(Notice::Kind::kWarning,
               fmt::format("{}: its map {} is not there; open the map's folder to see it", path,
                           document->header.map_path));
  }
  reconcile();
}

void Session::Implementation::take_map_of(std::size_t index) {
  const std::string path = runs[index].path.string();
  const std::string map_path = works[index].map_path;
  const std::string map_before = kept.view.map_path;
  const auto wished = map_wishes.find(path);
  const bool is_wished = wished != map_wishes.end();
  const MapWish wish = is_wished ? wished->second : MapWish{};
  if (is_wished) map_wishes.erase(wished);
  const OpenRun* const run = active();
  const bool is_active = run != nullptr && run->path.string() == path;
  // A view that came with a map of its own keeps it.
  if (!is_active || map_before == map_path || (!is_wished && !map_before.empty())) return;
  // It belongs to the opening of the run, so states since then get it too.
  amend(
      [&](KeptState& state) {
        const auto number = static_cast<std::size_t>(state.view.active_run);
        if (number == 0 || number > state.view.runs.size()) return;
        if (state.view.runs[number - 1].path != path || state.view.map_path != map_before) return;
        state.view.map_path = map_path;
        if (!map_before.empty() && !wish.keeps_sight) state.view.map.width_m = 0.0;
      },
      wish.since);
}

void Session::Implementation::begin_flight(const std::string& path) {
  FlightWork& work = flights[path];
  if (work.recording || work.reading || work.has_failed) return;
  std::vector<std::string> opened = recents;
  if (!places.bundled_map.empty()) opened.push_back(places.bundled_map.string());
  const bool is_opened_by_itself = path == kept.view.flight_path;
  work.reading.emplace([path, opened, is_opened_by_itself](
                           const WorkContext& context,
                           const auto& /*publish*/) -> Result<ReadFlight> {
    auto flight = open_flight(path);
    if (!flight) return forward_error(flight);
    std::string hash = is_opened_by_itself ? flight_hash((*flight)->description()) : std::string();
    return ReadFlight{std::move(*flight), maps_of_flight(path, opened, context), std::move(hash)};
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
    work.recording = std::move(read->recording);
    work.maps = std::move(read->maps);
    work.hash = std::move(read->hash);
    if (kept.view.flight_path == path) remember(path);
    for (std::size_t i = 0; i < runs.size(); ++i) {  // it may be the moved one of a run
      const bool is_missing = runs[i].document && works[i].flight_path.empty();
      if (is_missing && !work.hash.empty() && runs[i].document->header.flight_hash == work.hash) {
        works[i].flight_path = path;
      }
    }
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

void Session::Implementation::offer_localising() {
  const std::string& path = kept.view.flight_path;
  const auto found = flights.find(path);
  bool is_of_run = false;  // or may yet turn out to be
  for (std::size_t i = 0; i < runs.size(); ++i) {
    is_of_run = is_of_run || works[i].flight_path == path || !runs[i].document;
  }
  const bool is_ready = !path.empty() && !is_of_run && reruns.empty() && map && map->index &&
                        found != flights.end() && found->second.recording &&
                        can_be_localised(found->second.recording->description());
  if (!is_ready) {
    forget_notices([this](const Notice& notice) { return notice.number == offer_number; });
    offer_number = 0;
    offered.clear();
    return;
  }
  const std::string offer = path + "\n" + map->path.string();
  if (offer == offered) return;
  offered = offer;
  forget_notices([this](const Notice& notice) { return notice.number == offer_number; });
  const FlightDescription& flight = found->second.recording->description();
  Notice notice;
  notice.text = fmt::format("{} can be localised on {} now, with the settings of the next run",
                            flight.name, map->provenance.name);
  notice.remedy = actions::Rerun{RerunFrom::kFlight};
  notice.remedy_title = "Localise now";
  add_notice(notice);
  offer_number = last_number;
  WindowLayout& layout = kept.view.layout;
  // Beside a moment that there is not yet.
  if (runs.empty() && layout.shows(Panel::kSettings)) layout.right_tab = Panel::kSettings;
}

void Session::Implementation::take_map() {
  if (!map_reading || !map_reading->is_done()) return;
  auto read = std::move(*map_reading->outcome());
  map_reading.reset();
  if (read) {
    map->provenance = std::move(read->provenance);
    map->index = std::move(read->index);
    map->hash = std::move(read->hash);
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

const std::string& Session::Implementation::flight_path() const {
  const OpenRun* const run = active();
  return run != nullptr ? works[static_cast<std::size_t>(run - runs.data())].flight_path
                        : kept.view.flight_path;
}

std::shared_ptr<const FlightRecording> Session::Implementation::flight_of(
    const std::string& path) const {
  const auto found = flights.find(path);
  return found != flights.end() ? found->second.recording : nullptr;
}

}  // namespace nadir
