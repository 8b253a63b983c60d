// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/icons.h"

namespace nadir::kit {

std::string icon_text(Icon icon) {
  const auto code = static_cast<unsigned>(icon);
  if (code == 0) return {};
  return {static_cast<char>(0xE0U | (code >> 12U)),
          static_cast<char>(0x80U | ((code >> 6U) & 0x3FU)),
          static_cast<char>(0x80U | (code & 0x3FU))};
}

std::string icon_name(Icon icon) {
  switch (icon) {
    case Icon::kPlay:
      return "play";
    case Icon::kPause:
      return "pause";
    case Icon::kStop:
      return "stop";
    case Icon::kStepBack:
      return "step back";
    case Icon::kStepForward:
      return "step forward";
    case Icon::kFirst:
      return "first";
    case Icon::kLast:
      return "last";
    case Icon::kRepeat:
      return "repeat";
    case Icon::kEye:
      return "eye";
    case Icon::kEyeSlash:
      return "eye slash";
    case Icon::kSearch:
      return "search";
    case Icon::kZoomIn:
      return "zoom in";
    case Icon::kZoomOut:
      return "zoom out";
    case Icon::kUndo:
      return "undo";
    case Icon::kRedo:
      return "redo";
    case Icon::kGear:
      return "gear";
    case Icon::kPlus:
      return "plus";
    case Icon::kMinus:
      return "minus";
    case Icon::kClose:
      return "close";
    case Icon::kMore:
      return "more";
    case Icon::kBookmark:
      return "bookmark";
    case Icon::kLocate:
      return "locate";
    case Icon::kCompass:
      return "compass";
    case Icon::kRuler:
      return "ruler";
    case Icon::kMap:
      return "map";
    case Icon::kMapMarker:
      return "map marker";
    case Icon::kLayers:
      return "layers";
    case Icon::kCamera:
      return "camera";
    case Icon::kFilm:
      return "film";
    case Icon::kCube:
      return "cube";
    case Icon::kChart:
      return "chart";
    case Icon::kBars:
      return "bars";
    case Icon::kTable:
      return "table";
    case Icon::kDownload:
      return "download";
    case Icon::kUpload:
      return "upload";
    case Icon::kFolder:
      return "folder";
    case Icon::kFolderOpen:
      return "folder open";
    case Icon::kFile:
      return "file";
    case Icon::kSave:
      return "save";
    case Icon::kCopy:
      return "copy";
    case Icon::kPaste:
      return "paste";
    case Icon::kPencil:
      return "pencil";
    case Icon::kPaintBrush:
      return "paint brush";
    case Icon::kEraser:
      return "eraser";
    case Icon::kTrash:
      return "trash";
    case Icon::kWarning:
      return "warning";
    case Icon::kInfo:
      return "info";
    case Icon::kCheck:
      return "check";
    case Icon::kError:
      return "error";
    case Icon::kSun:
      return "sun";
    case Icon::kMoon:
      return "moon";
    case Icon::kQuestion:
      return "question";
    case Icon::kKeyboard:
      return "keyboard";
    case Icon::kRefresh:
      return "refresh";
    case Icon::kLock:
      return "lock";
    case Icon::kUnlock:
      return "unlock";
    case Icon::kArrowUp:
      return "arrow up";
    case Icon::kArrowDown:
      return "arrow down";
    case Icon::kArrowLeft:
      return "arrow left";
    case Icon::kArrowRight:
      return "arrow right";
    case Icon::kCaretUp:
      return "caret up";
    case Icon::kCaretDown:
      return "caret down";
    case Icon::kCaretLeft:
      return "caret left";
    case Icon::kCaretRight:
      return "caret right";
    case Icon::kExpand:
      return "expand";
    case Icon::kCompress:
      return "compress";
    case Icon::kMove:
      return "move";
    case Icon::kGrip:
      return "grip";
    case Icon::kFilter:
      return "filter";
    case Icon::kStar:
      return "star";
    case Icon::kStarOutline:
      return "star outline";
    case Icon::kList:
      return "list";
    case Icon::kClock:
      return "clock";
    case Icon::kFlag:
      return "flag";
    case Icon::kLink:
      return "link";
    case Icon::kExternal:
      return "external";
    case Icon::kPlane:
      return "plane";
    case Icon::kSplit:
      return "split";
    case Icon::kPointer:
      return "pointer";
    case Icon::kShare:
      return "vertices";
    case Icon::kObject:
      return "object";
    case Icon::kBuilding:
      return "building";
    case Icon::kSquare:
      return "square";
    case Icon::kCircle:
      return "circle";
    case Icon::kRoad:
      return "road";
    case Icon::kHole:
      return "hole";
    case Icon::kScissors:
      return "scissors";
    case Icon::kTint:
      return "drop";
    case Icon::kExchange:
      return "exchange";
    case Icon::kBug:
      return "bug";
    case Icon::kNone:
      break;
  }
  return {};
}

}  // namespace nadir::kit
