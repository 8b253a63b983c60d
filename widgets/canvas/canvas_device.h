// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkContextDevice2D.h>

#include <memory>
#include <vector>

#include "widgets/canvas/canvas.h"

class vtkMatrix3x3;

namespace nadir {

/// Lets VTK's charts and context items draw on a Canvas: pixels, PDF or SVG, without OpenGL.
///
/// VTK's own SVG and PDF devices write text as outlines, dash by fixed pixels and lose clipping; this one does not.
/// Font families mean roles here: Arial is the program's text face, Courier its face for numbers. Textures of brushes,
/// sprites and colours along a line's vertices beyond its first are not supported; none of our items uses them.
class CanvasDevice : public vtkContextDevice2D {
 public:
  static CanvasDevice* New();
  vtkTypeMacro(CanvasDevice, vtkContextDevice2D) CanvasDevice(const CanvasDevice&) = delete;
  CanvasDevice& operator=(const CanvasDevice&) = delete;

  /// @param canvas  Outlives the drawing. @param width, height  Of the page, pixels.
  void draw_on(Canvas& canvas, int width, int height);

  void DrawPoly(float* points, int n, unsigned char* colors, int nc_comps) override;
  void DrawLines(float* points, int n, unsigned char* colors, int nc_comps) override;
  void DrawPoints(float* points, int n, unsigned char* colors, int nc_comps) override;
  void DrawPointSprites(
      vtkImageData*, float* points, int n, unsigned char* colors, int nc_comps) override;
  void DrawMarkers(int shape,
                   bool highlight,
                   float* points,
                   int n,
                   unsigned char* colors,
                   int nc_comps) override;
  void DrawQuad(float* points, int n) override;
  void DrawQuadStrip(float* points, int n) override;
  void DrawPolygon(float* points, int n) override;
  void DrawColoredPolygon(float* points, int n, unsigned char* colors, int nc_comps) override;
  void DrawEllipseWedge(float x,
                        float y,
                        float outer_x,
                        float outer_y,
                        float inner_x,
                        float inner_y,
                        float start_deg,
                        float stop_deg) override;
  void DrawEllipticArc(
      float x, float y, float radius_x, float radius_y, float start_deg, float stop_deg) override;
  void DrawString(float* point, const vtkStdString& string) override;
  void DrawString(float* point, const vtkUnicodeString& string) override;
  void ComputeStringBounds(const vtkStdString& string, float bounds[4]) override;
  void ComputeStringBounds(const vtkUnicodeString& string, float bounds[4]) override;
  void ComputeJustifiedStringBounds(const char* string, float bounds[4]) override;
  void DrawMathTextString(float* point, const vtkStdString& string) override;
  void DrawImage(float point[2], float scale, vtkImageData* image) override;
  void DrawImage(const vtkRectf& where, vtkImageData* image) override;
  void SetColor4(unsigned char color[4]) override;
  void SetTexture(vtkImageData*, int) override {}
  void SetPointSize(float size) override;
  void SetLineWidth(float width) override;
  void SetLineType(int type) override;
  void SetMatrix(vtkMatrix3x3* matrix) override;
  void GetMatrix(vtkMatrix3x3* matrix) override;
  void MultiplyMatrix(vtkMatrix3x3* matrix) override;
  void PushMatrix() override;
  void PopMatrix() override;
  void SetClipping(int* box) override;
  void EnableClipping(bool enable) override;

 protected:
  CanvasDevice();
  ~CanvasDevice() override;

 private:
  [[nodiscard]] std::vector<Eigen::Vector2d> on_page(const float* points, int n) const;
  [[nodiscard]] StrokeStyle stroke_style() const;
  [[nodiscard]] TextStyle text_style() const;
  /// Lower left corner, width and height of a text box that has its justification point at the origin, rotated.
  [[nodiscard]] PageRect text_box(const std::string& text) const;
  void draw_text(const Eigen::Vector2d& point, const std::string& text);

  Canvas* canvas_ = nullptr;
  Eigen::Matrix3d page_from_item_ = Eigen::Matrix3d::Identity();
  std::vector<Eigen::Matrix3d> saved_;
  PageRect clip_;
  bool is_clipping_ = false;
};

}  // namespace nadir
