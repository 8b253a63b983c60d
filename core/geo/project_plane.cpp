// SPDX-License-Identifier: Apache-2.0
#include "core/geo/project_plane.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kMaxLatitudeDeg = 89.0;
constexpr double kMaxLongitudeDeg = 180.0;

const GeographicLib::TransverseMercator& transverse_mercator() {
  static const GeographicLib::TransverseMercator projection(
      GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), 1.0);
  return projection;
}

/// Northing of the origin when counted from the equator.
double equator_to_origin_m(const Geodetic& origin) {
  double x_m = 0.0;
  double y_m = 0.0;
  transverse_mercator().Forward(origin.longitude_deg, origin.latitude_deg, origin.longitude_deg,
                                x_m, y_m);
  return y_m;
}

struct GridReference {
  std::string zone;  ///< With its latitude band: "17S", near the poles "Z".
  double easting_m = 0.0;
  double northing_m = 0.0;
  std::string square;  ///< Two letters and the digits, without spaces.
};

/// Nothing where the position is not on the Earth.
std::optional<GridReference> grid_reference(const Geodetic& position, int digits) {
  try {
    int zone = 0;
    bool is_north = true;
    GridReference reference;
    GeographicLib::UTMUPS::Forward(position.latitude_deg, position.longitude_deg, zone, is_north,
                                   reference.easting_m, reference.northing_m);
    std::string text;
    GeographicLib::MGRS::Forward(zone, is_north, reference.easting_m, reference.northing_m,
                                 position.latitude_deg, digits, text);
    std::size_t zone_size = 0;
    while (zone_size < text.size() &&
           std::isdigit(static_cast<unsigned char>(text[zone_size])) != 0) {
      ++zone_size;
    }
    ++zone_size;  // the band's letter
    reference.zone = text.substr(0, zone_size);
    reference.square = text.substr(zone_size);
    return reference;
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
}

bool is_on_earth(const Geodetic& position) {
  return std::abs(position.latitude_deg) <= 90.0 && std::isfinite(position.longitude_deg);
}

constexpr std::string_view kNoPlace = "no place";

/// "83.901223 W"; the letter is that of the rounded number, so that there is no "0.000000 S".
std::string degrees_text(double degrees, char positive, char negative) {
  const double rounded = std::round(degrees * 1e6) / 1e6;
  return fmt::format("{:.6f} {}", std::abs(rounded), rounded < 0.0 ? negative : positive);
}

}  // namespace

Result<ProjectPlane> ProjectPlane::create(const Geodetic& origin) {
  if (!(std::abs(origin.latitude_deg) <= kMaxLatitudeDeg)) {
    return fail(ErrorCode::kInvalidOptions, "map origin: latitude {} is not in [-89, 89] degrees",
                origin.latitude_deg);
  }
  if (!(std::abs(origin.longitude_deg) <= kMaxLongitudeDeg)) {
    return fail(ErrorCode::kInvalidOptions,
                "map origin: longitude {} is not in [-180, 180] degrees", origin.longitude_deg);
  }
  return ProjectPlane(origin);
}

Eigen::Vector2d ProjectPlane::enu_from_geodetic(const Geodetic& position) const {
  double east_m = 0.0;
  double from_equator_m = 0.0;
  transverse_mercator().Forward(origin_.longitude_deg, position.latitude_deg,
                                position.longitude_deg, east_m, from_equator_m);
  return {east_m, from_equator_m - equator_to_origin_m(origin_)};
}

Geodetic ProjectPlane::geodetic_from_enu(const Eigen::Vector2d& position_in_enu_m) const {
  Geodetic position;
  transverse_mercator().Reverse(origin_.longitude_deg, position_in_enu_m.x(),
                                position_in_enu_m.y() + equator_to_origin_m(origin_),
                                position.latitude_deg, position.longitude_deg);
  return position;
}

double ProjectPlane::convergence_deg(const Eigen::Vector2d& position_in_enu_m) const {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double clockwise_deg = 0.0;  // GeographicLib: the bearing of grid north
  double scale = 1.0;
  transverse_mercator().Reverse(origin_.longitude_deg, position_in_enu_m.x(),
                                position_in_enu_m.y() + equator_to_origin_m(origin_), latitude_deg,
                                longitude_deg, clockwise_deg, scale);
  return -clockwise_deg;
}

std::string ProjectPlane::wkt() const {
  // Shortest text of the same double: never fewer digits than the origin has.
  return fmt::format(
      R"(PROJCS["Nadir project plane",)"
      R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],)"
      R"(AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],)"
      R"(UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AUTHORITY["EPSG","4326"]],)"
      R"(PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",{}],)"
      R"(PARAMETER["central_meridian",{}],PARAMETER["scale_factor",1],PARAMETER["false_easting",0],)"
      R"(PARAMETER["false_northing",0],UNIT["metre",1,AUTHORITY["EPSG","9001"]],)"
      R"(AXIS["Easting",EAST],AXIS["Northing",NORTH]])",
      origin_.latitude_deg, origin_.longitude_deg);
}

std::string geodetic_text(const Geodetic& position) {
  if (!is_on_earth(position)) return std::string(kNoPlace);
  return degrees_text(position.latitude_deg, 'N', 'S') + " " +
         degrees_text(std::remainder(position.longitude_deg, 360.0), 'E', 'W');
}

std::string utm_text(const Geodetic& position) {
  if (!is_on_earth(position)) return std::string(kNoPlace);
  const auto reference = grid_reference(position, 0);
  if (!reference) return std::string(kNoPlace);
  return fmt::format("{} {:.1f} E {:.1f} N", reference->zone, reference->easting_m,
                     reference->northing_m);
}

std::string mgrs_text(const Geodetic& position, int digits) {
  constexpr int kMaxDigits = 11;  // GeographicLib's limit: a micrometre
  constexpr std::size_t kLetters = 2;
  NADIR_REQUIRE(digits >= 0 && digits <= kMaxDigits);
  if (!is_on_earth(position)) return std::string(kNoPlace);
  const auto reference = grid_reference(position, digits);
  if (!reference) return std::string(kNoPlace);
  std::string text = reference->zone + " " + reference->square.substr(0, kLetters);
  if (digits > 0) {
    const auto half = static_cast<std::size_t>(digits);
    text += " " + reference->square.substr(kLetters, half) + " " +
            reference->square.substr(kLetters + half);
  }
  return text;
}

}  // namespace nadir
