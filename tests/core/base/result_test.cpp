// SPDX-License-Identifier: Apache-2.0
#include "core/base/result.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/require.h"

namespace nadir {
namespace result_test {

Result<int> failing() { return fail(ErrorCode::kMalformed, "{}: line {} is wrong", "a.tum", 7); }

Result<std::string> forwarding() {
  const auto inner = failing();
  if (!inner) return forward_error(inner, "flight.toml");
  return std::string("fine");
}

TEST(Result, CarriesTheCodeAndTheSentence) {
  const auto result = failing();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kMalformed);
  EXPECT_EQ(result.error().message, "a.tum: line 7 is wrong");
}

TEST(Result, PassesAnErrorOnWithItsContextInFront) {
  const auto result = forwarding();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kMalformed);
  EXPECT_EQ(result.error().message, "flight.toml: a.tum: line 7 is wrong");
}

TEST(Require, NamesTheBrokenPreconditionAndItsPlace) {
  try {
    NADIR_REQUIRE(1 + 1 == 3);
    FAIL() << "nothing was thrown";
  } catch (const std::logic_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("result_test.cpp:"), std::string::npos) << message;
    EXPECT_NE(message.find("1 + 1 == 3"), std::string::npos) << message;
  }
}

TEST(WorkContext, WithoutListenersDoesNothing) {
  const WorkContext context;
  context.report(0.5, "half way");
  EXPECT_FALSE(context.is_stopped());
}

TEST(WorkContext, ReportsAndIsStopped) {
  std::stop_source source;
  std::vector<double> fractions;
  const WorkContext context{source.get_token(), [&](double fraction, const std::string&) {
                              fractions.push_back(fraction);
                            }};
  context.report(0.25, "a quarter");
  EXPECT_EQ(fractions, std::vector<double>{0.25});
  EXPECT_FALSE(context.is_stopped());
  source.request_stop();
  EXPECT_TRUE(context.is_stopped());
}

}  // namespace result_test
}  // namespace nadir
