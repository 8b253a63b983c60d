// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/error_text.h"
#include "tests/widgets/panels/made_moment.h"
#include "widgets/panels/moment_inquiry.h"

namespace nadir {

[[nodiscard]] inline MomentQuestion question_of(const MadeMoment& made) {
  MomentQuestion question;
  question.step = made.step;
  question.map = made.map;
  question.options_key = "defaults";
  return question;
}

[[nodiscard]] inline std::shared_ptr<const MomentAnswer> answer_of(const MomentQuestion& question) {
  const auto matcher = MapMatcher::create(question.map, question.options.localiser);
  EXPECT_TRUE(matcher) << error_text(matcher);
  return std::make_shared<const MomentAnswer>(answer_moment(question, *matcher));
}

}  // namespace nadir
