// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/vtk_messages.h"

#include <gmock/gmock.h>
#include <vtkObjectFactory.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp.h>
#include <vtkRenderer.h>

#include "tests/support/collected_log.h"
#include "tests/support/error_text.h"
#include "widgets/gl/offscreen_renderer.h"
#include "widgets/gl/render_window.h"

namespace nadir {
namespace vtk_messages_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// Runs something that VTK complains of; what reaches the log, with standard error empty.
template <typename Action>
std::vector<std::string> complaints_of(Action&& action) {
  const CollectedLog log;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  action();
  EXPECT_THAT(testing::internal::GetCapturedStdout(), IsEmpty());
  EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
  return log.lines();
}

class Complaining : public vtkObject {
 public:
  static Complaining* New() { VTK_STANDARD_NEW_BODY(Complaining); }
  void complain() {
    vtkErrorMacro("broken\nin two lines");
    vtkWarningMacro("odd " << 3);
    vtkGenericWarningMacro("of nobody");
  }

 protected:
  Complaining() = default;
};

class UndrawableProp : public vtkProp {
 public:
  static UndrawableProp* New() { VTK_STANDARD_NEW_BODY(UndrawableProp); }
  int RenderOpaqueGeometry(vtkViewport* /*viewport*/) override {
    vtkErrorMacro("cannot be drawn");
    return 0;
  }

 protected:
  UndrawableProp() = default;
};

TEST(VtkMessages, ComeOutThroughTheLogAndNowhereElse) {
  send_vtk_messages_to_log();
  const vtkNew<Complaining> object;
  EXPECT_THAT(complaints_of([&] { object->complain(); }),
              ElementsAre("error: VTK: vtkObject: broken in two lines",
                          "warning: VTK: vtkObject: odd 3", "warning: VTK: of nobody"));
}

TEST(VtkMessages, AreInstalledByTheRenderWindow) {
  const vtkNew<RenderWindow> window;
  const auto lines = complaints_of([] {
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->Update();  // has no input
  });
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_THAT(lines.front(), AllOf(StartsWith("error: VTK: "), HasSubstr("Input port 0")));
  EXPECT_THAT(lines.front(),
              AllOf(Not(HasSubstr("0x")), Not(HasSubstr(".cxx")), Not(HasSubstr(", line"))));
}

TEST(VtkMessages, OfARenderingEndNeitherItNorTheProgram) {
  auto offscreen = OffscreenRenderer::create();
  ASSERT_TRUE(offscreen) << error_text(offscreen);
  const vtkNew<vtkRenderer> scene;
  const vtkNew<UndrawableProp> prop;
  scene->AddViewProp(prop);
  scene->SetBackground(1.0, 0.0, 0.0);
  scene->SetBackgroundAlpha(1.0);
  Raster<Rgba> pixels;
  const auto lines = complaints_of([&] { pixels = (*offscreen)->render(*scene, 20, 10).value(); });
  EXPECT_EQ(pixels.at(1, 1), (Rgba{255, 0, 0}));
  EXPECT_THAT(lines, ElementsAre("error: VTK: vtkProp: cannot be drawn"));
}

TEST(VtkMessages, AreSilentWhereVtkIsToldToBe) {
  send_vtk_messages_to_log();
  const vtkNew<Complaining> object;
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_THAT(complaints_of([&] { object->complain(); }), IsEmpty());
  vtkObject::GlobalWarningDisplayOn();
}

TEST(PlainVtkMessage, LeavesPlacesAndAddressesOut) {
  EXPECT_EQ(plain_vtk_message(
                "ERROR: In ./Common/vtkFoo.cxx, line 772\nvtkFoo (0x55c3a2f0): no input\n\n"),
            "vtkFoo: no input");
  EXPECT_EQ(
      plain_vtk_message("Generic Warning: In /build/a b/vtkBar.cxx, line 9\nno such array\n\n"),
      "no such array");
  EXPECT_EQ(plain_vtk_message("Warning: In x.cxx, line 1\nvtkA (0x1): asked by vtkB (0x7fff01AB)"),
            "vtkA: asked by vtkB");
  EXPECT_EQ(plain_vtk_message("said without a place"), "said without a place");
  EXPECT_EQ(plain_vtk_message(""), "");
}

TEST(PlainVtkMessage, KeepsTheBeginningOfWhatIsEndless) {
  const std::string shader =
      "ERROR: In a.cxx, line 1\nvtkShader (0x2): bad\n" + std::string(500'000, 'x');
  EXPECT_THAT(plain_vtk_message(shader), StartsWith("vtkShader: bad\nxxx"));
  EXPECT_LT(plain_vtk_message(shader).size(), 2'001U);
}

}  // namespace vtk_messages_test
}  // namespace nadir
