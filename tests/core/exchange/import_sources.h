// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "core/exchange/label_import.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {

/// Small sources that tests import. One thousandth of a degree north is 111.2 m, one east at this latitude 73.1 m.

/// "<node id='3' lat='49.002' lon='8.001'/>": `north` and `east` in thousandths of a degree from 49 N 8 E.
[[nodiscard]] inline std::string node(int id, double north, double east) {
  return fmt::format("<node id='{}' lat='{:.7f}' lon='{:.7f}'/>\n", id, 49.0 + north / 1000.0,
                     8.0 + east / 1000.0);
}
[[nodiscard]] inline std::string tags_text(const ImportTags& tags) {
  std::string text;
  for (const auto& [key, value] : tags) text += fmt::format("<tag k='{}' v='{}'/>", key, value);
  return text;
}
[[nodiscard]] inline std::string way(int id,
                                     const std::vector<int>& nodes,
                                     const ImportTags& tags = {}) {
  std::string text = fmt::format("<way id='{}'>", id);
  for (const int ref : nodes) text += fmt::format("<nd ref='{}'/>", ref);
  return text + tags_text(tags) + "</way>\n";
}
[[nodiscard]] inline std::string relation(int id,
                                          const std::vector<std::pair<int, std::string>>& ways,
                                          const ImportTags& tags) {
  std::string text = fmt::format("<relation id='{}'>", id);
  for (const auto& [ref, role] : ways) {
    text += fmt::format("<member type='way' ref='{}' role='{}'/>", ref, role);
  }
  return text + tags_text(tags) + "</relation>\n";
}
[[nodiscard]] inline std::string osm(const std::string& elements) {
  return "<?xml version='1.0' encoding='UTF-8'?>\n<osm version='0.6'>\n" + elements + "</osm>\n";
}

[[nodiscard]] inline ImportRules bundled_rules(const std::string& name) {
  return ImportRules::read(NADIR_SOURCE_DIR "/resources/rules/" + name).value();
}

/// What a file becomes by the program's own rules, on a plane of its own.
struct Imported {
  LabelDocument document;
  ImportedLabels labels;

  [[nodiscard]] std::string notices() const {
    std::string text;
    for (const std::string& notice : labels.notices) text += notice + "\n";
    return text;
  }
  [[nodiscard]] const LabelObject& object(std::size_t index) const {
    return *labels.edit.objects.at(index).after;
  }
};
[[nodiscard]] inline Imported import_all(const std::filesystem::path& path,
                                         double metres_per_cell = 0.5) {
  const auto source = ImportSource::read(path);
  if (!source) throw std::runtime_error(source.error().message);
  const ImportRules rules = bundled_rules(source->usual_rules());
  auto document = source->plan_document(rules, metres_per_cell);
  if (!document) throw std::runtime_error(document.error().message);
  auto labels = source->objects(rules, *document);
  if (!labels) throw std::runtime_error(labels.error().message);
  const auto fits = document->check(labels->edit);
  EXPECT_TRUE(fits) << error_text(fits);
  document->apply(labels->edit);
  return {*std::move(document), *std::move(labels)};
}
[[nodiscard]] inline Imported import_osm(const std::string& elements) {
  const ScratchFolder folder;
  return import_all(folder.file("map.osm", osm(elements)));
}

/// Of a border without its holes, square metres.
[[nodiscard]] inline double area_of_ring(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    twice += ring[j].x() * ring[i].y() - ring[i].x() * ring[j].y();
  }
  return std::abs(twice) / 2.0;
}

}  // namespace nadir
