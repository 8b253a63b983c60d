// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/session/actions_export.h"
#include "core/session/actions_files.h"
#include "core/session/actions_history.h"
#include "core/session/actions_label.h"
#include "core/session/actions_label_edit.h"
#include "core/session/actions_layout.h"
#include "core/session/actions_map.h"
#include "core/session/actions_runs.h"
#include "core/session/actions_time.h"
#include "core/session/view_state.h"

/// Everything that a user can ask for. Menu, palette, shortcut, script and log all speak of the same actions by the same
/// words: kForm is the command with its arguments, kHelp what it does. Each group has a header of its own.
namespace nadir {

/// All kinds of them.
using AnyAction = std::variant<actions::OpenFile,
                               actions::OpenDemo,
                               actions::CloseRun,
                               actions::SaveNow,
                               actions::Quit,
                               actions::Seek,
                               actions::GoToMoment,
                               actions::StepBy,
                               actions::GoTo,
                               actions::Play,
                               actions::SetSpeed,
                               actions::SetLoop,
                               actions::LookAt,
                               actions::Zoom,
                               actions::Rotate,
                               actions::Fit,
                               actions::Follow,
                               actions::SetUp,
                               actions::GoToPlace,
                               actions::LayTopview,
                               actions::SelectParticle,
                               actions::MeasurePoint,
                               actions::UseTool,
                               actions::ShowLayer,
                               actions::SetLayerOpacity,
                               actions::SetLayerColour,
                               actions::MoveLayer,
                               actions::ShowPanel,
                               actions::MoveSplitter,
                               actions::MapOnly,
                               actions::SplitView,
                               actions::SaveLayout,
                               actions::UseLayout,
                               actions::SetTheme,
                               actions::SetScale,
                               actions::ReduceMotion,
                               actions::SetMemory,
                               actions::ShowStrip,
                               actions::MoveStrip,
                               actions::SetStripHeight,
                               actions::ShowOverlay,
                               actions::ActivateRun,
                               actions::ShowRun,
                               actions::GoToDivergence,
                               actions::SetOption,
                               actions::UsePreset,
                               actions::SavePreset,
                               actions::Rerun,
                               actions::CancelJob,
                               actions::ExportFigure,
                               actions::ExportTable,
                               actions::WriteReport,
                               actions::Copy,
                               actions::CopyView,
                               actions::PasteView,
                               actions::AddBookmark,
                               actions::EditBookmark,
                               actions::RemoveBookmark,
                               actions::OpenLabels,
                               actions::CloseLabels,
                               actions::SetWorkspace,
                               actions::ShowLabelTab,
                               actions::ShowBorders,
                               actions::SetLabelOpacity,
                               actions::SetLabelOption,
                               actions::LastClass,
                               actions::AddPlace,
                               actions::TraceTo,
                               actions::TypeLeg,
                               actions::FinishTool,
                               actions::CancelTool,
                               actions::DrawArea,
                               actions::DrawLine,
                               actions::DrawOutline,
                               actions::DrawStreet,
                               actions::CutHole,
                               actions::StrokeLabels,
                               actions::FillLabels,
                               actions::RecodeLabels,
                               actions::SelectLabels,
                               actions::SelectBox,
                               actions::MoveVertex,
                               actions::AddVertex,
                               actions::MoveLabels,
                               actions::DuplicateLabels,
                               actions::CopyBeside,
                               actions::EditLabels,
                               actions::SetLabel,
                               actions::JoinBorders,
                               actions::SplitLabels,
                               actions::PasteLabels,
                               actions::GoToLabelStep,
                               actions::ExportLabels,
                               actions::ImportLabels,
                               actions::SaveLabelsCopy,
                               actions::DismissNotice,
                               actions::Undo,
                               actions::Redo>;

template <typename One, typename Any>
inline constexpr bool kIsOneOf = false;
template <typename One, typename... Kinds>
inline constexpr bool kIsOneOf<One, std::variant<Kinds...>> = (std::is_same_v<One, Kinds> || ...);
template <typename One>
concept OneOfActions = kIsOneOf<One, AnyAction>;

/// One thing that a user asked for. A class of its own, so that copying and destroying a hundred kinds is compiled in one
/// place; std::visit, std::get_if and std::holds_alternative take it as the variant that it is.
class Action : public AnyAction {
 public:
  Action() = default;
  template <OneOfActions One>
  Action(One one)  // NOLINT(google-explicit-constructor): an action is one of its kinds
      : AnyAction(std::in_place_type<One>, std::move(one)) {}
  Action(const Action& other);
  Action(Action&& other) noexcept;
  Action& operator=(const Action& other);
  Action& operator=(Action&& other) noexcept;
  ~Action();
};

/// What a panel returns: usually none, at most a few.
using Actions = std::vector<Action>;

/// The words of an action: "seek 12.5", "layer particles off", "export \"my figures/a.svg\"". Its last text argument is
/// quoted where it needs to be; parse_action() gives the same action again.
[[nodiscard]] std::string action_text(const Action& action);

/// @errors kInvalidOptions: no such action (names the nearest), too many, too few or wrong arguments, in one sentence that
/// says the form: "seek abc: SECONDS is not a number (seek SECONDS)".
[[nodiscard]] Result<Action> parse_action(std::string_view text);

/// Name, form and help of every action, in the order above.
struct ActionHelp {
  std::string_view name, form, help;
};
[[nodiscard]] std::vector<ActionHelp> action_helps();
[[nodiscard]] std::string_view action_name(const Action& action);

}  // namespace nadir
