// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/report.h"

#include <gmock/gmock.h>
#include <vtkNew.h>

#include <set>

#include "core/base/staged_output.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/canvas/xml_reading.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/report_page.h"

namespace nadir {
namespace report_test {

namespace fs = std::filesystem;

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class Report : public ::testing::Test {
 protected:
  Report() { write_street(map()); }
  [[nodiscard]] fs::path map() const { return scratch_.path() / "map"; }
  [[nodiscard]] fs::path out() const { return scratch_.path() / "out"; }
  std::string drive(const std::string& name, const RunFaults& faults = {}) {
    fs::create_directories((scratch_.path() / name).parent_path());
    write_drive(scratch_.path() / name, map(), 12, faults);
    return (scratch_.path() / name).string();
  }
  Result<ReportSummary> write(const std::vector<std::string>& runs, const WorkContext& work = {}) {
    ReportRequest request{runs, "", {}};
    request.options.size.width = 320;
    return write_report(request, out(), work);
  }
  [[nodiscard]] std::string index() const { return read_text_file(out() / "index.html").value(); }

  ScratchFolder scratch_;
};

/// The file that a URL of the page names.
std::string decoded(const std::string& url) {
  std::string path;
  for (std::size_t i = 0; i < url.size(); ++i) {
    if (url[i] == '%') {
      path += static_cast<char>(std::stoi(url.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      path += url[i];
    }
  }
  return path;
}

TEST_F(Report, IsAWellFormedPageWhoseLinksAllLeadSomewhere) {
  const std::vector<std::string> runs = {drive("a #1?.nadir"), drive("50% ü&\"<x>.nadir")};
  const auto summary = write(runs);
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_THAT(summary->left_out, IsEmpty());
  const std::string page = index();
  constexpr std::string_view kDoctype = "<!DOCTYPE html>\n";
  ASSERT_TRUE(page.starts_with(kDoctype));
  vtkNew<XmlReading> reading;
  ASSERT_EQ(reading->Parse(page.c_str() + kDoctype.size()), 1);
  ASSERT_TRUE(reading->is_well_formed);
  std::set<std::string> ids;
  for (const XmlElement& element : reading->elements) {
    if (element.attributes.count("id") == 0) continue;
    EXPECT_TRUE(ids.insert(element["id"]).second) << element["id"];
  }
  std::set<std::string> linked;
  for (const auto& [name, attribute] : {std::pair("a", "href"), std::pair("img", "src")}) {
    for (const XmlElement& element : reading->named(name)) {
      const std::string url = element[attribute];
      if (url.starts_with('#')) {
        EXPECT_EQ(ids.count(url.substr(1)), 1U) << url;
        continue;
      }
      EXPECT_EQ(url.find_first_of(" ?#\"<>&"), std::string::npos) << url;
      EXPECT_TRUE(fs::exists(out() / decoded(url))) << url;
      linked.insert(decoded(url));
    }
  }
  for (const auto& entry : fs::directory_iterator(out())) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name == "index.html" || linked.count(name) == 1) << name;
  }
  EXPECT_EQ(reading->named("img").size(), static_cast<std::size_t>(summary->figures));
}

TEST_F(Report, HasATableOfErrorsAndTheFactsOfEachRun) {
  ASSERT_TRUE(write({drive("seen.nadir"), drive("blind.nadir", {.has_truth = false})}));
  vtkNew<XmlReading> reading;
  const std::string page = index();
  ASSERT_EQ(reading->Parse(page.c_str() + page.find('\n') + 1), 1);
  std::vector<std::string> cells;
  for (const XmlElement& cell : reading->named("td")) cells.push_back(cell.text);
  for (const char* fact : {"drive", "street", "default", "Nadir 0.1.0", "estimate / odometry",
                           "its truth is not known, so there are no errors"}) {
    EXPECT_THAT(cells, Contains(fact));
  }
  // The odometry drifts by 0.1 m a step: 0 to 1.1 m, median 0.55 m.
  EXPECT_THAT(cells, Contains("0.55"));
  EXPECT_THAT(cells, Contains("1.10"));
}

TEST_F(Report, DrawsTheSameBytesAsASingleFigure) {
  const std::string run = drive("a.nadir");
  ASSERT_TRUE(write({run}));
  FigureRecipe recipe;
  recipe.runs = {run};
  recipe.options.size.width = 320;
  for (const char* figure : {"flight", "trajectories", "reconstruction", "labels", "consistency"}) {
    recipe.figure = figure;
    FigureSources sources;
    const auto alone = draw_recipe(recipe, PageFile::kPng, sources, {});
    ASSERT_TRUE(alone) << alone.error().message;
    EXPECT_EQ(read_text_file(out() / (std::string(figure) + ".png")).value(), *alone) << figure;
  }
}

TEST_F(Report, IsTheSameEveryTime) {
  const std::vector<std::string> runs = {drive("a.nadir"), drive("b.nadir", {.shift_m = 3.0})};
  ASSERT_TRUE(write(runs));
  const fs::path first = scratch_.path() / "first";
  fs::rename(out(), first);
  ASSERT_TRUE(write(runs));
  for (const auto& entry : fs::directory_iterator(first)) {
    const fs::path name = entry.path().filename();
    EXPECT_EQ(read_text_file(entry.path()).value(), read_text_file(out() / name).value()) << name;
  }
}

TEST_F(Report, DrawsEachRunOnItsOwnMap) {
  const std::string first = drive("a.nadir");
  const fs::path other = scratch_.path() / "other";
  write_street(other, false);
  write_drive(scratch_.path() / "b.nadir", other, 12, {.flight_hash = "2"});
  const auto summary = write({first, (scratch_.path() / "b.nadir").string()});
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_TRUE(fs::exists(out() / "overhead-pair.png"));
  EXPECT_TRUE(fs::exists(out() / "overhead-pair-2.png"));
  // With a picture and without one.
  EXPECT_NE(fs::file_size(out() / "trajectories-1-a.png"),
            fs::file_size(out() / "trajectories-2-b.png"));
}

TEST_F(Report, LeavesOutWhatTheRunsDoNotAllow) {
  const std::string blind = drive("blind.nadir", {.has_truth = false, .has_topviews = false});
  const auto summary = write({blind});
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_THAT(summary->left_out, Contains(HasSubstr("flight: ")));
  EXPECT_THAT(summary->left_out, Contains(HasSubstr("reconstruction: ")));
  EXPECT_THAT(index(), HasSubstr("<h2>Left out</h2>"));
  EXPECT_FALSE(fs::exists(out() / "flight.png"));
  EXPECT_TRUE(fs::exists(out() / "trajectories.png"));
}

TEST_F(Report, HasTheChartsOfARunWhoseMapIsGone) {
  const std::string run = drive("a.nadir");
  fs::remove_all(map());
  const auto summary = write({run});
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_THAT(summary->left_out,
              ElementsAre(HasSubstr("figures over the map: " + run + ": its map ")));
  EXPECT_TRUE(fs::exists(out() / "cdf.svg"));
  EXPECT_FALSE(fs::exists(out() / "trajectories.png"));
}

TEST_F(Report, AsksForItsFolderBeforeItReadsARun) {
  const auto refused =
      write_report({{"no-such-run.nadir"}, "", {}}, scratch_.path() / "none" / "out", {});
  EXPECT_THAT(error_text(refused), HasSubstr("none does not exist"));
}

TEST_F(Report, StopsWithoutLeavingAPiece) {
  std::stop_source stop;
  const WorkContext work{stop.get_token(), [&stop](double fraction, const std::string&) {
                           if (fraction > 0.2) stop.request_stop();
                         }};
  const std::string run = drive("a.nadir");
  const auto before = scratch_.entries();
  const auto stopped = write({run}, work);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::kCancelled);
  EXPECT_FALSE(fs::exists(out()));
  EXPECT_EQ(scratch_.entries(), before);
}

TEST_F(Report, HasTheColoursOfItsFigures) {
  ReportRequest request{{drive("a.nadir")}, "", {}};
  request.options.size.width = 320;
  request.options.theme = ThemeName::kDark;
  ASSERT_TRUE(write_report(request, out(), {}));
  EXPECT_THAT(index(), HasSubstr("color-scheme: dark"));
  EXPECT_THAT(index(), HasSubstr("background: #1B1F23"));
  EXPECT_THAT(index(), Not(HasSubstr("#FFFFFF")));
}

TEST(UrlPath, EncodesWhatHasAMeaningInUrls) {
  EXPECT_EQ(url_path("flight-1-a.b_c~d/e"), "flight-1-a.b_c~d/e");
  EXPECT_EQ(url_path("a b#c?d%e&f"), "a%20b%23c%3Fd%25e%26f");
  EXPECT_EQ(url_path("ü"), "%C3%BC");
}

/// Localised over the whole map, with truth from a later step on: nothing says where the odometry began.
TEST_F(Report, HasTheErrorsOfARunWithoutOdometryInThePlane) {
  const auto run = open_figure_run(drive("global.nadir", {.has_odometry = false}), {});
  ASSERT_TRUE(run);
  const std::string table = error_table({&*run, 1});
  EXPECT_THAT(table, Not(HasSubstr("truth is not known")));
  vtkNew<XmlReading> reading;
  ASSERT_EQ(reading->Parse(("<page>" + table + "</page>").c_str()), 1);
  std::vector<std::string> cells;
  for (const XmlElement& cell : reading->named("td")) cells.push_back(cell.text);
  ASSERT_THAT(cells, ::testing::SizeIs(10 + 12 + 10));
  const auto row = [&cells](std::size_t first) {
    return std::vector<std::string>(cells.begin() + static_cast<std::ptrdiff_t>(first),
                                    cells.begin() + static_cast<std::ptrdiff_t>(first) + 9);
  };
  const std::string dash = "–";
  EXPECT_THAT(row(0),
              ElementsAre("odometry (input)", dash, dash, dash, dash, dash, dash, dash, dash));
  EXPECT_EQ(row(10)[0], "estimate");
  EXPECT_THAT(row(10), Not(Contains(dash)));
  EXPECT_THAT(row(22),
              ElementsAre("estimate / odometry", dash, dash, dash, dash, dash, dash, dash, dash));
}

TEST_F(Report, SaysWhichRunWasStoppedBeforeItsEnd) {
  ASSERT_TRUE(write({drive("whole.nadir"), drive("killed.nadir", {.is_finished = false})}));
  vtkNew<XmlReading> reading;
  const std::string page = index();
  ASSERT_EQ(reading->Parse(page.c_str() + page.find('\n') + 1), 1);
  std::vector<std::string> cells;
  for (const XmlElement& cell : reading->named("td")) cells.push_back(cell.text);
  EXPECT_THAT(cells, Contains("12"));
  EXPECT_THAT(cells, Contains("12 (stopped before its end)"));
  const std::string table = read_text_file(out() / "table.txt").value();
  EXPECT_THAT(table, HasSubstr("killed.nadir (stopped before its end)\n"));
  EXPECT_THAT(table, HasSubstr("whole.nadir\n"));
}

}  // namespace report_test
}  // namespace nadir
