// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/session/action_fields.h"

/// What leaves the window.
namespace nadir::actions {

struct ExportFigure {
  static constexpr std::string_view kForm = "export FILE [FIGURE] [WIDTH]";
  static constexpr std::string_view kHelp =
      "Draw this moment, or another figure, as .png, .svg or .pdf, or the loop's range as .mp4; so "
      "many pixels wide";
  std::string file;
  std::optional<std::string> figure = {};
  std::optional<int> width_px = {};  ///< Only with a figure's name.
  NADIR_ACTION_FIELDS(file, figure, width_px)
  friend bool operator==(const ExportFigure&, const ExportFigure&) = default;
};

struct ExportTable {
  static constexpr std::string_view kForm = "export-table FILE";
  static constexpr std::string_view kHelp = "Every step of the active run as .csv";
  std::string file;
  NADIR_ACTION_FIELDS(file)
  friend bool operator==(const ExportTable&, const ExportTable&) = default;
};

struct WriteReport {
  static constexpr std::string_view kForm = "report FOLDER";
  static constexpr std::string_view kHelp =
      "All figures and tables of the shown runs with an index page";
  std::string folder;
  NADIR_ACTION_FIELDS(folder)
  friend bool operator==(const WriteReport&, const WriteReport&) = default;
};

struct Copy {
  static constexpr std::string_view kForm = "copy TEXT";
  static constexpr std::string_view kHelp = "Put a text on the clipboard";
  std::string text;
  NADIR_ACTION_FIELDS(text)
  friend bool operator==(const Copy&, const Copy&) = default;
};

/// The window's whole look as text, to send to somebody or to keep.
struct CopyView {
  static constexpr std::string_view kForm = "copy-view";
  static constexpr std::string_view kHelp =
      "Put this view, its moment and its runs on the clipboard as text";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const CopyView&, const CopyView&) = default;
};

struct PasteView {
  static constexpr std::string_view kForm = "paste-view TEXT";
  static constexpr std::string_view kHelp = "Show what copy-view has put on the clipboard";
  std::string text;
  NADIR_ACTION_FIELDS(text)
  friend bool operator==(const PasteView&, const PasteView&) = default;
};

}  // namespace nadir::actions
