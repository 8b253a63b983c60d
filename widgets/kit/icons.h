// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace nadir::kit {

/// Pictograms of the one icon font, Fork Awesome. The values are its code points, all in Unicode's private use area.
enum class Icon : std::uint16_t {
  kNone = 0,
  kPlay = 0xf04b,
  kPause = 0xf04c,
  kStop = 0xf04d,
  kStepBack = 0xf048,
  kStepForward = 0xf051,
  kFirst = 0xf049,
  kLast = 0xf050,
  kRepeat = 0xf079,
  kEye = 0xf06e,
  kEyeSlash = 0xf070,
  kSearch = 0xf002,
  kZoomIn = 0xf00e,
  kZoomOut = 0xf010,
  kUndo = 0xf0e2,
  kRedo = 0xf01e,
  kGear = 0xf013,
  kPlus = 0xf067,
  kMinus = 0xf068,
  kClose = 0xf00d,
  kMore = 0xf142,  ///< Three dots above each other: a menu.
  kBookmark = 0xf02e,
  kLocate = 0xf05b,
  kCompass = 0xf14e,
  kRuler = 0xf07e,  ///< A double arrow: the font has no ruler.
  kMap = 0xf279,
  kMapMarker = 0xf041,
  kLayers = 0xf24d,
  kCamera = 0xf030,
  kFilm = 0xf008,
  kCube = 0xf1b2,
  kChart = 0xf201,
  kBars = 0xf080,
  kTable = 0xf0ce,
  kDownload = 0xf019,
  kUpload = 0xf093,
  kFolder = 0xf07b,
  kFolderOpen = 0xf07c,
  kFile = 0xf15b,
  kSave = 0xf0c7,
  kCopy = 0xf0c5,
  kPaste = 0xf0ea,
  kPencil = 0xf040,
  kPaintBrush = 0xf1fc,
  kEraser = 0xf12d,
  kTrash = 0xf1f8,
  kWarning = 0xf071,
  kInfo = 0xf05a,
  kCheck = 0xf00c,
  kError = 0xf06a,
  kSun = 0xf185,
  kMoon = 0xf186,
  kQuestion = 0xf128,
  kKeyboard = 0xf11c,
  kRefresh = 0xf021,
  kLock = 0xf023,
  kUnlock = 0xf09c,
  kArrowUp = 0xf062,
  kArrowDown = 0xf063,
  kArrowLeft = 0xf060,
  kArrowRight = 0xf061,
  kCaretUp = 0xf0d8,
  kCaretDown = 0xf0d7,
  kCaretLeft = 0xf0d9,
  kCaretRight = 0xf0da,
  kExpand = 0xf065,
  kCompress = 0xf066,
  kMove = 0xf047,
  kGrip = 0xf0c9,  ///< Where a row is taken to move it.
  kFilter = 0xf0b0,
  kStar = 0xf005,
  kStarOutline = 0xf006,
  kList = 0xf03a,
  kClock = 0xf017,
  kFlag = 0xf024,
  kLink = 0xf0c1,
  kExternal = 0xf08e,
  kPlane = 0xf072,
  kSplit = 0xf0db,
  kBug = 0xf188,
  kPointer = 0xf245,
  kShare = 0xf1e0,  ///< Three dots joined by lines.
  kObject = 0xf247,
  kBuilding = 0xf1ad,
  kSquare = 0xf096,
  kCircle = 0xf10c,
  kRoad = 0xf018,
  kHole = 0xf192,  ///< A dot within a ring.
  kScissors = 0xf0c4,
  kTint = 0xf043,
  kExchange = 0xf0ec,
};

/// The icon as UTF-8, to be put into any label; empty for kNone.
[[nodiscard]] std::string icon_text(Icon icon);

/// The same without the glyph: what it shows in one word ("play"), for logs and tests.
[[nodiscard]] std::string icon_name(Icon icon);

}  // namespace nadir::kit
