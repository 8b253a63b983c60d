// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/export_box.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/made_folders.h"
#include "tests/widgets/panels/shown.h"
#include "widgets/panels/file_box.h"

namespace nadir {
namespace export_box_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A model as a session with a run would give it.
struct ExportOnDisk : ExportModel {
  MadeFolders disk;
  PaletteState palette;
  ExportOnDisk() {
    is_open = true;
    first_folder = "/data/flights";
    for (const ExportKind& kind : export_kinds()) rows.push_back({&kind, ""});
  }
};
Actions draw_export_on_disk(kit::Ui& ui, ExportOnDisk& model, ExportState& state) {
  model.disk.show(state.files, model.files);
  model.proposed = "loop-" + state.chosen;
  const ExportKind& kind = *export_kind(state.chosen);
  std::vector<std::string_view> endings;
  for (const std::string_view ending : export_endings(kind.form)) {
    endings.insert(ending == state.ending ? endings.begin() : endings.end(), ending);
  }
  const SavePlace place = save_place(model.files, state.files, endings);
  model.file = place.file;
  model.replaces = place.replaces;
  model.why_not = place.why_not;
  model.sentence = "Draws into " + place.file;
  return draw_export_box(ui, model, state, model.palette);
}
using Export = Shown<ExportOnDisk, ExportState, draw_export_on_disk>;

TEST(ExportBox, ListsEveryKindWithItsLine) {
  Export box;
  box.wait();
  for (const ExportKind& kind : export_kinds()) {
    const std::string row = "Export/Kinds/" + std::string(kind.name);
    ASSERT_TRUE(box.screen.has(row)) << row;
    EXPECT_EQ(box.screen.at(row + "/What").value, kind.title);
    EXPECT_EQ(box.screen.at(row + "/It shows").value, kind.line);
  }
}

TEST(ExportBox, SaysWhatOfTheMapWillNotBeInIt) {
  Export box;
  box.wait(4);
  EXPECT_FALSE(box.screen.shows("Not in it"));
  box.model.left_out = "Not in it: the error surface.";
  box.wait();
  EXPECT_TRUE(box.screen.shows("Not in it: the error surface."));
}

TEST(ExportBox, SaysAllThatThereIsToBeWarnedOfAtOnce) {
  Export box;
  box.model.disk.add("/data/flights", "loop-moment.png", FileKind::kFigure);
  box.model.left_out = "Not in it: the error surface.";
  box.wait(4);
  EXPECT_TRUE(box.screen.shows("There is such a file already")) << box.screen.words();
  EXPECT_TRUE(box.screen.shows("Not in it: the error surface."));
}

TEST(ExportBox, ProposesANameForWhatIsChosenAndMakesItOnEnter) {
  Export box;
  box.wait(4);
  EXPECT_EQ(box.screen.at("Export/##Name").value, "loop-moment.png");
  EXPECT_THAT(box.press("Enter"),
              ElementsAre("show none", "export /data/flights/loop-moment.png moment"));
}

TEST(ExportBox, ProposesAnotherNameForAnotherKindUnlessOneWasTyped) {
  Export box;
  box.wait(4);
  box.click("Export/Kinds/cdf");
  box.wait();
  EXPECT_EQ(box.screen.at("Export/##Name").value, "loop-cdf.png");
  box.click("Export/Kinds/table");
  box.wait();
  EXPECT_EQ(box.screen.at("Export/##Name").value, "loop-table.csv");
  box.type("Export/##Name", "mine", false);
  box.click("Export/Kinds/cdf");
  box.wait();
  EXPECT_EQ(box.screen.at("Export/##Name").value, "mine");
  EXPECT_THAT(box.click("Export/Export##take"),
              ElementsAre("show none", "export /data/flights/mine.png cdf"));
}

TEST(ExportBox, ChangesTheEndingWithTheFormat) {
  Export box;
  box.wait(4);
  box.click("Export/Format/SVG");
  box.wait();
  EXPECT_EQ(box.screen.at("Export/##Name").value, "loop-moment.svg");
  EXPECT_THAT(box.click("Export/Export##take"),
              ElementsAre("show none", "export /data/flights/loop-moment.svg moment"));
}

TEST(ExportBox, MakesTablesReportsAndFilms) {
  const std::vector<std::pair<std::string, std::string>> made = {
      {"table", "export-table /data/flights/loop-table.csv"},
      {"report", "report /data/flights/loop-report"},
      {"film", "export /data/flights/loop-film.mp4 moment"}};
  for (const auto& [kind, words] : made) {
    Export box;
    box.click("Export/Kinds/" + kind);
    box.wait();
    EXPECT_THAT(box.click("Export/Export##take"), ElementsAre("show none", words));
  }
}

TEST(ExportBox, WarnsBeforeItReplaces) {
  Export box;
  box.model.disk.add("/data/flights", "loop-moment.png", FileKind::kFigure);
  box.wait(4);
  EXPECT_TRUE(box.screen.shows("There is such a file already")) << box.screen.words();
  EXPECT_THAT(box.press("Enter"), IsEmpty());
  box.wait();
  EXPECT_TRUE(box.screen.shows("Enter once more")) << box.screen.words();
  EXPECT_THAT(box.press("Enter"), Contains(HasSubstr("loop-moment.png")));
}

TEST(ExportBox, SaysWhatItWillDoOrWhyItCannot) {
  Export box;
  box.wait(4);
  EXPECT_TRUE(box.screen.shows("Draws into /data/flights/loop-moment.png"));
  box.type("Export/##Name", "/nowhere/x", false);
  EXPECT_TRUE(box.screen.shows("/nowhere: does not exist")) << box.screen.words();
  EXPECT_FALSE(box.screen.at("Export/Export##take").is_enabled);
}

TEST(ExportBox, GivesTheReasonInPlaceOfTheLineOfWhatCannotBeMade) {
  Export box;
  box.model.rows[4].why_not = "show a second run first";
  box.wait(4);
  EXPECT_EQ(box.screen.at("Export/Kinds/compare/It shows").value, "show a second run first");
}

TEST(ExportBox, BeginsWithWhatAMenuHasAskedFor) {
  Export box;
  box.model.is_open = false;
  box.wait(2);
  box.model.palette.begun = "report";
  box.model.is_open = true;
  box.wait(4);
  EXPECT_EQ(box.state.chosen, "report");
  EXPECT_EQ(box.model.palette.begun, "") << "the palette asks for nothing more";
  EXPECT_EQ(box.screen.at("Export/##Name").value, "loop-report");
}

TEST(ExportBox, GoesIntoFoldersAndKeepsTheName) {
  Export box;
  box.wait(4);
  box.double_click("Export/Names/2018");
  box.wait();
  EXPECT_EQ(box.state.files.folder, "/data/flights/2018");
  EXPECT_EQ(box.screen.at("Export/##Name").value, "loop-moment.png");
}

TEST(ExportBox, ClosesByEscapeAndFitsIntoASmallWindow) {
  Export box;
  box.screen.input().size_px = {760.0, 480.0};
  box.wait(5);
  EXPECT_TRUE(box.fits());
  EXPECT_LE(box.screen.at("Export/Export##take").rect.bottom(), 480.0);
  EXPECT_THAT(box.press("Escape"), Contains("show none"));
}

TEST(ExportModel, OfANewSessionSaysWhyNothingCanBeMade) {
  const ScratchFolder folder;
  Session session({folder.path() / "config", folder.path() / "data", {}});
  FolderReader reader;
  ExportState state;
  EXPECT_FALSE(export_model(session, state, reader).is_open);
  ASSERT_TRUE(session.apply(actions::ShowOverlay{Overlay::kExport}));
  const ExportModel model = export_model(session, state, reader);
  ASSERT_TRUE(model.is_open);
  EXPECT_EQ(model.rows.size(), export_kinds().size());
  EXPECT_EQ(model.why_not, "open a run first");
}

TEST(ExportModel, ReadsAWidthAndRefusesOneOutOfRange) {
  const ScratchFolder folder;
  Session session({folder.path() / "config", folder.path() / "data", {}});
  ASSERT_TRUE(session.apply(actions::ShowOverlay{Overlay::kExport}));
  FolderReader reader;
  ExportState state;
  state.width = " 2400 ";
  EXPECT_EQ(export_model(session, state, reader).width_px, 2400);
  for (const char* const wrong : {"10", "99999", "wide", "1600.5", "-1600"}) {
    state.width = wrong;
    const ExportModel model = export_model(session, state, reader);
    EXPECT_FALSE(model.width_px) << wrong;
    EXPECT_THAT(model.width_fault, HasSubstr("[200, 16000] pixels")) << wrong;
  }
  state.width = "wide";
  state.chosen = "table";
  EXPECT_EQ(export_model(session, state, reader).width_fault, "") << "a table has none";
}

}  // namespace export_box_test
}  // namespace nadir
