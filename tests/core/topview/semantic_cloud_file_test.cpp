// SPDX-License-Identifier: Apache-2.0
#include "core/topview/semantic_cloud_file.h"

#include <gmock/gmock.h>

#include "core/base/staged_output.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace semantic_cloud_file_test {

using testing::HasSubstr;

class SemanticCloudFile : public testing::Test {
 protected:
  [[nodiscard]] static SemanticCloud some_cloud() {
    return {
        {{1.5F, -2.25F, 0.125F}, {1.6F, -2.25F, 0.0F}, {1.5F, -2.3F, 0.0F}, {19.0F, 0.0F, 3.0F}},
        {kRoad, kCurb, kLaneMarking, kBuilding}};
  }
  ScratchFolder scratch_;
};

TEST_F(SemanticCloudFile, ReadsBackWhatItWroteAsPcdAndAsPly) {
  for (const char* name : {"cloud.pcd", "cloud.ply"}) {
    ASSERT_TRUE(write_semantic_cloud(some_cloud(), scratch_.path() / name).has_value());
    const auto again = read_semantic_cloud(scratch_.path() / name);
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_EQ(*again, some_cloud()) << name;
  }
}

TEST_F(SemanticCloudFile, RefusesOtherEndingsAndMissingFiles) {
  EXPECT_THAT(write_semantic_cloud(some_cloud(), scratch_.path() / "cloud.las").error().message,
              HasSubstr("ends neither in .pcd nor in .ply"));
  EXPECT_THAT(read_semantic_cloud(scratch_.path() / "none.pcd").error().message,
              HasSubstr("does not exist"));
}

TEST_F(SemanticCloudFile, RefusesAFileThatIsCutShortAnywhereInOneSentence) {
  for (const std::string ending : {".pcd", ".ply"}) {
    const auto whole_path = scratch_.path() / ("whole" + ending);
    ASSERT_TRUE(write_semantic_cloud(some_cloud(), whole_path).has_value());
    const std::string bytes = read_text_file(whole_path).value();
    for (std::size_t length = 0; length < bytes.size(); length += 3) {
      const auto cut = read_semantic_cloud(scratch_.file("cut" + ending, bytes.substr(0, length)));
      ASSERT_FALSE(cut.has_value()) << ending << " of " << length << " bytes";
      ASSERT_THAT(cut.error().message, HasSubstr("cut" + ending));
      ASSERT_EQ(cut.error().message.find('\n'), std::string::npos);
    }
  }
}

TEST_F(SemanticCloudFile, RefusesHeadersThatLie) {
  const std::string header =
      "VERSION .7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n";
  EXPECT_THAT(read_semantic_cloud(
                  scratch_.file("a.pcd", header + "WIDTH 9\nHEIGHT 1\nPOINTS 8\nDATA ascii\n"))
                  .error()
                  .message,
              HasSubstr("no whole PCD header"));
  EXPECT_THAT(
      read_semantic_cloud(
          scratch_.file("b.pcd",
                        header + "WIDTH 999999999\nHEIGHT 1\nPOINTS 999999999\nDATA binary\n"))
          .error()
          .message,
      HasSubstr("claims 999999999 points"));
  EXPECT_THAT(read_semantic_cloud(
                  scratch_.file("c.pcd",
                                "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                                "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n"))
                  .error()
                  .message,
              HasSubstr("no field 'label'"));
}

TEST_F(SemanticCloudFile, LosesThePointThatHasNoNeighbours) {
  const SemanticCloud kept = without_outliers(some_cloud(), 0.5, 1);
  EXPECT_THAT(kept.labels, testing::UnorderedElementsAre(kRoad, kCurb, kLaneMarking));
  EXPECT_EQ(without_outliers({}, 0.5, 1).size(), 0U);
}

}  // namespace semantic_cloud_file_test
}  // namespace nadir
