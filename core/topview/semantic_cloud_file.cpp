// SPDX-License-Identifier: Apache-2.0
#include "core/topview/semantic_cloud_file.h"

#include <pcl/common/io.h>
#include <pcl/console/print.h>
#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <exception>

#include "core/base/require.h"
#include "core/base/staged_output.h"
#include "core/topview/point_file_header.h"

namespace nadir {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZL>;

/// PCL prints its complaints; ours come back as errors.
class QuietPcl {
 public:
  QuietPcl() : level_(pcl::console::getVerbosityLevel()) {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL level_;
};

PclCloud to_pcl(const SemanticCloud& cloud) {
  PclCloud result;
  result.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    pcl::PointXYZL point;
    point.getVector3fMap() = cloud.points_in_level_m[i];
    point.label = cloud.labels[i];
    result.push_back(point);
  }
  return result;
}

SemanticCloud from_pcl(const PclCloud& cloud) {
  SemanticCloud result;
  for (const pcl::PointXYZL& point : cloud) {
    result.points_in_level_m.emplace_back(point.x, point.y, point.z);
    result.labels.push_back(point.label < kClassCount ? static_cast<ClassId>(point.label)
                                                      : static_cast<ClassId>(kUnclassified));
  }
  return result;
}

bool has_field(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  return pcl::getFieldIndex(cloud, name) >= 0;
}

}  // namespace

Result<void> write_semantic_cloud(const SemanticCloud& cloud, const std::filesystem::path& path) {
  const QuietPcl quiet;
  const std::string ending = path.extension().string();
  if (ending != ".pcd" && ending != ".ply") {
    return fail(ErrorCode::kUnsupported, "{}: ends neither in .pcd nor in .ply", path.string());
  }
  auto staged = StagedOutput::file(path);
  if (!staged) return forward_error(staged);
  try {
    const PclCloud points = to_pcl(cloud);
    const int outcome = ending == ".pcd"
                            ? pcl::io::savePCDFileBinary(staged->path().string(), points)
                            : pcl::io::savePLYFileBinary(staged->path().string(), points);
    if (outcome != 0) return fail(ErrorCode::kIo, "{}: cannot be written", path.string());
  } catch (const std::exception& error) {
    return fail(ErrorCode::kIo, "{}: cannot be written: {}", path.string(), error.what());
  }
  return staged->commit();
}

Result<SemanticCloud> read_semantic_cloud(const std::filesystem::path& path) {
  const QuietPcl quiet;
  if (const auto whole = check_point_file(path); !whole) return forward_error(whole);
  const std::string ending = path.extension().string();
  try {
    pcl::PCLPointCloud2 raw;
    const int outcome = ending == ".pcd" ? pcl::PCDReader().read(path.string(), raw)
                                         : pcl::PLYReader().read(path.string(), raw);
    if (outcome != 0) {
      return fail(ErrorCode::kMalformed, "{}: is not a readable {} file", path.string(),
                  ending.substr(1));
    }
    for (const char* field : {"x", "y", "z", "label"}) {
      if (!has_field(raw, field)) {
        return fail(ErrorCode::kMalformed, "{}: has no field '{}'", path.string(), field);
      }
    }
    PclCloud points;
    pcl::fromPCLPointCloud2(raw, points);
    return from_pcl(points);
  } catch (const std::exception& error) {
    return fail(ErrorCode::kMalformed, "{}: cannot be read: {}", path.string(), error.what());
  }
}

SemanticCloud without_outliers(const SemanticCloud& cloud, double radius_m, int min_neighbours) {
  NADIR_REQUIRE(radius_m > 0.0 && min_neighbours >= 0);
  if (cloud.size() == 0) return cloud;
  pcl::RadiusOutlierRemoval<pcl::PointXYZL> filter;
  filter.setInputCloud(pcl::make_shared<PclCloud>(to_pcl(cloud)));
  filter.setRadiusSearch(radius_m);
  filter.setMinNeighborsInRadius(min_neighbours);
  PclCloud kept;
  filter.filter(kept);
  return from_pcl(kept);
}

}  // namespace nadir
