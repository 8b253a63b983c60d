// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_blobs.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"

namespace nadir::detail {
namespace run_blobs_test {

using testing::HasSubstr;

ParticleSet example_particles() { return *example_step(3, 200).particles; }
SemanticTopview example_topview() { return *example_step(3, 200).topview; }
const Rigid2 kEstimate{500.0, 200.0, 0.1};

TEST(ParticleBlob, GivesBackPosesAndWeightsToThePromisedDigits) {
  ParticleSet particles = example_particles();
  particles.x_in_enu_m[0] = kEstimate.x_m + 8000.0 / 3.0;
  particles.yaw_rad[1] = std::numbers::pi;
  const auto blob = encode_particles(particles, kEstimate);
  ASSERT_TRUE(blob) << error_text(blob);
  const auto read = decode_particles(*blob, 200, kEstimate);
  ASSERT_TRUE(read) << error_text(read);
  ASSERT_EQ(read->size(), 200U);
  double sum = 0.0;
  for (std::size_t i = 0; i < read->size(); ++i) {
    EXPECT_NEAR(read->x_in_enu_m[i], particles.x_in_enu_m[i], 6e-4);
    EXPECT_NEAR(read->y_in_enu_m[i], particles.y_in_enu_m[i], 6e-4);
    EXPECT_NEAR(wrap_rad(read->yaw_rad[i] - particles.yaw_rad[i]), 0.0, 2e-7);
    EXPECT_LE(read->yaw_rad[i], std::numbers::pi);
    EXPECT_NEAR(read->weight[i], particles.weight[i], 1e-7 * particles.weight[i]);
    sum += read->weight[i];
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(ParticleBlob, MayBeEmpty) {
  const auto blob = encode_particles({}, kEstimate);
  ASSERT_TRUE(blob);
  EXPECT_TRUE(decode_particles(*blob, 0, kEstimate)->empty());
}

TEST(ParticleBlob, IsRefusedWhereItsCountIsNotItsSize) {
  const Bytes blob = encode_particles(example_particles(), kEstimate).value();
  for (const std::int64_t count : {0, 199, 201, 10'000'000}) {
    EXPECT_THAT(error_text(decode_particles(blob, count, kEstimate)),
                HasSubstr("do not hold " + std::to_string(count) + " elements"));
  }
  for (const std::int64_t count : {std::int64_t{-1}, std::int64_t{10'000'001}, INT64_MAX}) {
    EXPECT_THAT(error_text(decode_particles(blob, count, kEstimate)), HasSubstr("is not in [0"));
  }
  EXPECT_FALSE(decode_particles({}, 0, kEstimate)) << "no bytes at all are no blob";
}

TEST(ParticleBlob, IsRefusedWithEveryFlippedBitOfItsDataAndWhenCutShort) {
  const Bytes good = encode_particles(example_particles(), kEstimate).value();
  for (std::size_t i = good.size() / 4; i < good.size(); i += 7) {  // Behind the frame's header.
    Bytes bad = good;
    bad[i] ^= 0x10U;
    const auto read = decode_particles(bad, 200, kEstimate);
    ASSERT_FALSE(read) << "byte " << i;
    EXPECT_EQ(error_code(read), ErrorCode::kMalformed);
  }
  for (std::size_t size = 0; size < good.size(); size += 11) {
    EXPECT_FALSE(decode_particles(std::span(good).first(size), 200, kEstimate)) << size;
  }
}

TEST(ParticleBlob, IsNotMadeOfNumbersThatAreNoParticles) {
  const auto fault = [](auto damage) {
    ParticleSet particles = example_particles();
    damage(particles);
    return error_text(encode_particles(particles, kEstimate));
  };
  EXPECT_THAT(fault([](ParticleSet& p) { p.x_in_enu_m[5] = std::nan(""); }),
              HasSubstr("particle 5 is no pose"));
  EXPECT_THAT(fault([](ParticleSet& p) { p.yaw_rad[7] = HUGE_VAL; }),
              HasSubstr("particle 7 is no pose"));
  EXPECT_THAT(fault([](ParticleSet& p) { p.weight[0] = -0.5; }),
              HasSubstr("particle 0 is no pose with a weight"));
  EXPECT_THAT(fault([](ParticleSet& p) { p.weight.assign(200, 0.0); }),
              HasSubstr("sum to nothing"));
}

TEST(ParticleBlob, IsRefusedWhereItsNumbersAreNoParticles) {
  // 16 cells of a topview have as many bytes as 5 particles: the x of particle 0 is `forward` of the
  // cells 0 and 1, its weight is `left` of the cells 14 and 15.
  SemanticTopview topview;
  topview.cells.resize(16);
  topview.class_begin.fill(16);
  topview.class_begin[0] = 0;
  const auto decoded = [&topview] {
    return decode_particles(encode_topview(topview).value(), 5, kEstimate);
  };
  EXPECT_THAT(error_text(decoded()), HasSubstr("its weights sum to nothing"));
  topview.cells[15].left = 0x3F80;  // 1
  ASSERT_TRUE(decoded()) << error_text(decoded());
  EXPECT_EQ(decoded()->weight[0], 1.0);
  topview.cells[1].forward = 0x7FC0;  // not a number
  EXPECT_THAT(error_text(decoded()), HasSubstr("particle 0 is no pose with a weight"));
  topview.cells[1].forward = 0;
  topview.cells[15].left = static_cast<std::int16_t>(0xBF80);  // -1
  EXPECT_THAT(error_text(decoded()), HasSubstr("particle 0 is no pose with a weight"));
}

TEST(TopviewBlob, IsNotMadeOfCellsThatHaveNoWidth) {
  SemanticTopview topview = example_topview();
  for (const double width_m : {0.0, -0.1, std::nan(""), HUGE_VAL}) {
    topview.metres_per_cell = width_m;
    EXPECT_THAT(error_text(encode_topview(topview)), HasSubstr("m wide"));
  }
}

TEST(TopviewBlob, GivesBackEveryCell) {
  SemanticTopview topview = example_topview();
  topview.cells[0] = {-32768, 32767};
  const auto blob = encode_topview(topview);
  ASSERT_TRUE(blob);
  const auto read = decode_topview(*blob, 3, 0.1);
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->metres_per_cell, 0.1);
  EXPECT_EQ(read->class_begin, topview.class_begin);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read->cells[i].forward, topview.cells[i].forward);
    EXPECT_EQ(read->cells[i].left, topview.cells[i].left);
  }
}

TEST(TopviewBlob, IsRefusedWhereCountCellWidthOrBytesAreWrong) {
  const Bytes blob = encode_topview(example_topview()).value();
  EXPECT_THAT(error_text(decode_topview(blob, 4, 0.1)), HasSubstr("do not hold 4 elements"));
  EXPECT_THAT(error_text(decode_topview(blob, -3, 0.1)), HasSubstr("its count -3"));
  for (const double width_m : {0.0, -0.1, std::nan(""), HUGE_VAL}) {
    EXPECT_THAT(error_text(decode_topview(blob, 3, width_m)), HasSubstr("m wide"));
  }
  Bytes flipped = blob;
  flipped.back() ^= 1U;  // The checksum itself.
  EXPECT_FALSE(decode_topview(flipped, 3, 0.1));
}

TEST(TopviewBlob, IsRefusedWhereItsClassesAreNone) {
  // Particles of the same number of bytes: 5 a cell, 16 a particle. Their last bytes are no
  // classes.
  const Bytes particles = encode_particles(*example_step(1, 5).particles, kEstimate).value();
  EXPECT_THAT(error_text(decode_topview(particles, 16, 0.1)), HasSubstr("are not grouped"));
}

}  // namespace run_blobs_test
}  // namespace nadir::detail
