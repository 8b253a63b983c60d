// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_blobs.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/require.h"
#include "core/base/zstd.h"

namespace nadir::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "run files hold little-endian arrays");

constexpr std::int64_t kMostElements = 10'000'000;
constexpr std::size_t kParticleBytes = 4 * sizeof(float);
constexpr std::size_t kCellBytes = 2 * sizeof(std::int16_t) + 1;

// What a blob may hold is checked on both sides, so that what was written can be read.

Result<void> check_count(std::int64_t count) {
  if (count >= 0 && count <= kMostElements) return {};
  return fail(ErrorCode::kMalformed, "its count {} is not in [0, {}]", count, kMostElements);
}

Result<void> check_cells(double metres_per_cell) {
  if (metres_per_cell > 0.0 && std::isfinite(metres_per_cell)) return {};
  return fail(ErrorCode::kMalformed, "its cells are {} m wide", metres_per_cell);
}

/// As stored.
struct StoredParticle {
  float x_m, y_m, yaw_rad, weight;
};

/// Goes through all particles in order. @errors kMalformed: one is no pose with a weight, or all
/// weights together are nothing.
class ParticleCheck {
 public:
  [[nodiscard]] Result<void> add(const StoredParticle& particle) {
    const auto [x_m, y_m, yaw_rad, weight] = particle;
    if (!std::isfinite(x_m) || !std::isfinite(y_m) || !std::isfinite(yaw_rad) ||
        !std::isfinite(weight) || weight < 0.0F) {
      return fail(ErrorCode::kMalformed, "particle {} is no pose with a weight", count_);
    }
    ++count_;
    sum_ += static_cast<double>(weight);
    return {};
  }
  /// The sum of the weights, above 0 unless there are no particles.
  [[nodiscard]] Result<double> end() const {
    if (count_ > 0 && !(sum_ > 0.0)) {
      return fail(ErrorCode::kMalformed, "its weights sum to nothing");
    }
    return sum_;
  }

 private:
  std::size_t count_ = 0;
  double sum_ = 0.0;
};

/// Checks the promised size before it allocates.
Result<Bytes> decompress(std::span<const std::uint8_t> packed,
                         std::int64_t count,
                         std::size_t element_bytes) {
  if (const auto checked = check_count(count); !checked) return forward_error(checked);
  const std::uint64_t expected = static_cast<std::uint64_t>(count) * element_bytes;
  if (zstd_content_bytes(packed) != expected) {
    return fail(ErrorCode::kMalformed, "its data do not hold {} elements", count);
  }
  auto raw = zstd_unpacked(packed, expected);
  if (!raw) return fail(ErrorCode::kMalformed, "its data cannot be unpacked");
  return std::move(*raw);
}

template <typename Element>
void put(Bytes& bytes, std::size_t index, Element value) {
  std::memcpy(bytes.data() + index * sizeof(Element), &value, sizeof(Element));
}

template <typename Element>
Element get(const std::uint8_t* bytes, std::size_t index) {
  Element value;
  std::memcpy(&value, bytes + index * sizeof(Element), sizeof(Element));
  return value;
}

}  // namespace

Result<Bytes> encode_particles(const ParticleSet& particles, const Rigid2& estimate_in_enu) {
  const std::size_t n = particles.size();
  NADIR_REQUIRE(particles.x_in_enu_m.size() == n && particles.y_in_enu_m.size() == n &&
                particles.yaw_rad.size() == n);
  const auto counted = check_count(static_cast<std::int64_t>(n));
  if (!counted) return forward_error(counted);
  Bytes raw(n * kParticleBytes);
  ParticleCheck check;
  for (std::size_t i = 0; i < n; ++i) {
    const StoredParticle particle = {
        static_cast<float>(particles.x_in_enu_m[i] - estimate_in_enu.x_m),
        static_cast<float>(particles.y_in_enu_m[i] - estimate_in_enu.y_m),
        static_cast<float>(particles.yaw_rad[i]), static_cast<float>(particles.weight[i])};
    if (const auto added = check.add(particle); !added) return forward_error(added);
    put(raw, i, particle.x_m);
    put(raw, n + i, particle.y_m);
    put(raw, 2 * n + i, particle.yaw_rad);
    put(raw, 3 * n + i, particle.weight);
  }
  if (const auto sum = check.end(); !sum) return forward_error(sum);
  return zstd_packed(raw);
}

Result<ParticleSet> decode_particles(std::span<const std::uint8_t> blob,
                                     std::int64_t count,
                                     const Rigid2& estimate_in_enu) {
  const auto raw = decompress(blob, count, kParticleBytes);
  if (!raw) return forward_error(raw);
  const auto n = static_cast<std::size_t>(count);
  ParticleSet particles;
  for (auto* values :
       {&particles.x_in_enu_m, &particles.y_in_enu_m, &particles.yaw_rad, &particles.weight}) {
    values->resize(n);
  }
  ParticleCheck check;
  for (std::size_t i = 0; i < n; ++i) {
    const StoredParticle particle = {get<float>(raw->data(), i), get<float>(raw->data(), n + i),
                                     get<float>(raw->data(), 2 * n + i),
                                     get<float>(raw->data(), 3 * n + i)};
    if (const auto added = check.add(particle); !added) return forward_error(added);
    particles.x_in_enu_m[i] = estimate_in_enu.x_m + static_cast<double>(particle.x_m);
    particles.y_in_enu_m[i] = estimate_in_enu.y_m + static_cast<double>(particle.y_m);
    // float's pi is above pi.
    particles.yaw_rad[i] = wrap_rad(static_cast<double>(particle.yaw_rad));
    particles.weight[i] = static_cast<double>(particle.weight);
  }
  const auto sum = check.end();
  if (!sum) return forward_error(sum);
  for (double& weight : particles.weight) weight /= *sum;
  return particles;
}

Result<Bytes> encode_topview(const SemanticTopview& topview) {
  const std::size_t n = topview.cells.size();
  NADIR_REQUIRE(topview.class_begin.front() == 0 && topview.class_begin.back() == n);
  const auto checked = check_count(static_cast<std::int64_t>(n)).and_then([&] {
    return check_cells(topview.metres_per_cell);
  });
  if (!checked) return forward_error(checked);
  Bytes raw(n * kCellBytes);
  for (std::size_t i = 0; i < n; ++i) {
    put(raw, i, topview.cells[i].forward);
    put(raw, n + i, topview.cells[i].left);
  }
  for (std::size_t id = 0; id < kClassCount; ++id) {
    for (std::size_t i = topview.class_begin.at(id); i < topview.class_begin.at(id + 1); ++i) {
      raw[4 * n + i] = static_cast<std::uint8_t>(id);
    }
  }
  return zstd_packed(raw);
}

Result<SemanticTopview> decode_topview(std::span<const std::uint8_t> blob,
                                       std::int64_t count,
                                       double metres_per_cell) {
  if (const auto checked = check_cells(metres_per_cell); !checked) return forward_error(checked);
  const auto raw = decompress(blob, count, kCellBytes);
  if (!raw) return forward_error(raw);
  const auto n = static_cast<std::size_t>(count);
  SemanticTopview topview;
  topview.metres_per_cell = metres_per_cell;
  topview.cells.resize(n);
  std::size_t last_class = 0;
  for (std::size_t i = 0; i < n; ++i) {
    topview.cells[i] = {get<std::int16_t>(raw->data(), i), get<std::int16_t>(raw->data(), n + i)};
    const std::size_t id = (*raw)[4 * n + i];
    if (id >= kClassCount || id < last_class) {
      return fail(ErrorCode::kMalformed, "its classes are not grouped");
    }
    ++topview.class_begin.at(id + 1);
    last_class = id;
  }
  for (std::size_t id = 0; id < kClassCount; ++id) {
    topview.class_begin.at(id + 1) += topview.class_begin.at(id);
  }
  return topview;
}

}  // namespace nadir::detail
