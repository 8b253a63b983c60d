// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/layers_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "widgets/panels/map_lines.h"

namespace nadir {
namespace {

// Of the design.
constexpr double kRowHeight = 28.0;
constexpr double kSliderWidth = 64.0, kLeastSlider = 32.0, kSwatchWidth = 22.0,
                 kBetweenControls = 8.0;
constexpr double kGripWidth = 16.0, kEyeWidth = 28.0, kBeforeEye = 2.0, kBeforeName = 4.0;
constexpr double kPercentOfLayer = 100.0;
constexpr const char* kOrderMenu = "order";  // of grip, eye and title

constexpr std::array<std::string_view, kLayerCount> kTitles = {
    "Picture",  "Labels", "Reconstruction", "Error surface", "Topview", "Disagreement", "Particles",
    "Odometry", "Truth",  "Estimate",       "Ellipses",      "Modes",   "Graticule",    "Legend"};

constexpr std::array<std::string_view, kLayerCount> kHelps = {
    "The overhead picture of the map",
    "The map's classes, as the localiser sees them",
    "All topviews up to now, laid at the estimates",
    "How well each place around the estimate explains what is seen",
    "What is seen from above at this moment",
    "Where topview and map say the same, and where not",
    "What the filter holds possible, coloured by weight",
    "Where dead reckoning alone would have gone",
    "Where the vehicle was",
    "Where the filter believes it was; arrows at the poses of now always lie on top",
    "One, two and three sigmas of the estimate's position; of other runs one and three",
    "Clusters of the particles with their share",
    "Lines of equal east and north, in metres",
    "What the colours mean; it always lies on top"};

Rgba layer_colour(const LayersModel& model, const LayersModel::Row& row, const Theme& theme) {
  const Rgba usual = usual_line_colour(row.layer, model, theme);
  if (!row.look.colour) return usual;
  return colour_from_hex(*row.look.colour).value_or(usual);
}

std::string hex_text(Rgba colour) {
  return fmt::format("#{:02X}{:02X}{:02X}", colour.red, colour.green, colour.blue);
}

void draw_colour(kit::Ui& ui,
                 const LayersModel& model,
                 const LayersModel::Row& row,
                 Actions& asked) {
  const auto edit =
      ui.colour("##colour", layer_colour(model, row, ui.theme()), {"Colour of its lines", ""});
  if (edit.is_changed || edit.was_committed) {
    asked.emplace_back(actions::SetLayerColour{row.layer, hex_text(edit.value)});
  }
  if (const auto menu = ui.context_menu("colour menu")) {
    kit::MenuItem item;
    if (!row.look.colour) item.disabled_because = "It is already";
    if (ui.menu_item("As the theme has it", item)) {
      asked.emplace_back(actions::SetLayerColour{row.layer, std::nullopt});
    }
  }
}

void draw_opacity(kit::Ui& ui, const LayersModel::Row& row, double width, Actions& asked) {
  kit::NumberOptions options;
  options.least = 0.0;
  options.most = 1.0;
  options.reset = 1.0;
  options.hint = {fmt::format("Opacity {:.0f} %", row.look.opacity * kPercentOfLayer), ""};
  ui.next_width(width);
  const auto edit = ui.small_slider("opacity", row.look.opacity, options);
  if (edit.is_changed || edit.was_committed)
    asked.emplace_back(actions::SetLayerOpacity{row.layer, edit.value});
}

/// What stands at the right of all rows, below each other.
struct LayerColumns {
  double slider = 0.0;  ///< Width; 0: there is no room for any.
  bool has_swatch = false;
};

/// In a narrow panel the sliders give way to the names, and then the colours; none for itself, for they stand in columns.
LayerColumns columns_for(const kit::Ui& ui, const LayersModel& model) {
  double plain = 0.0, coloured = 0.0;  // widest names of rows without and with a colour
  for (const LayersModel::Row& row : model.rows) {
    if (!row.why_empty.empty() || row.layer == Layer::kLegend) continue;
    double& widest = has_line_colour(row.layer) ? coloured : plain;
    widest = std::max(widest, ui.text_width(std::string(layer_title(row.layer))));
  }
  const double gap = ui.px(kBetweenControls), swatch = ui.px(kSwatchWidth);
  const double room = ui.room().width - ui.px(kGripWidth) - ui.px(kBeforeEye) - ui.px(kEyeWidth) -
                      ui.px(kBeforeName) - gap;
  LayerColumns columns;
  const double beside_names = room - std::max(plain, coloured + swatch + gap);
  columns.slider = std::floor(std::min(ui.px(kSliderWidth), beside_names));
  if (columns.slider < ui.px(kLeastSlider)) columns.slider = 0.0;
  columns.has_swatch = columns.slider > 0.0 || room - coloured >= swatch;
  return columns;
}

/// Up and down the list, for those who do not drag. The legend, which is the first row, stays there.
void draw_order_menu(kit::Ui& ui, const LayersModel& model, std::size_t place, Actions& asked) {
  const auto menu = ui.context_menu(kOrderMenu);
  if (!menu) return;
  const Layer layer = model.rows[place].layer;
  const auto last = static_cast<int>(model.rows.size()) - 1;
  const auto here = static_cast<int>(place);
  const auto item = [&](const std::string& label, int places, const std::string& why_not) {
    kit::MenuItem look;
    if (places == 0) look.disabled_because = why_not;
    if (layer == Layer::kLegend) look.disabled_because = "The legend always lies on top";
    if (ui.menu_item(label, look)) asked.emplace_back(actions::MoveLayer{layer, places});
  };
  item("Raise", here > 1 ? 1 : 0, "It is the uppermost");
  item("Lower", here < last ? -1 : 0, "It is the lowest");
  ui.menu_line();
  item("To the top", std::max(0, here - 1), "It is the uppermost");
  item("To the ground", here - last, "It is the lowest");
}

void draw_layer_row(kit::Ui& ui,
                    const LayersModel& model,
                    const LayerColumns& columns,
                    std::size_t place,
                    Actions& asked) {
  const LayersModel::Row& row = model.rows[place];
  const std::string name(enum_name(row.layer));
  const auto scope = ui.scope(name);
  {
    const auto fixed = ui.disabled(row.layer == Layer::kLegend, "The legend always lies on top");
    const auto grip = ui.grip("grip", place, model.rows.size(), ui.px(kRowHeight));
    if (grip.was_committed && grip.value != place) {
      // The first row is the top of the map: up the list is up there.
      asked.emplace_back(
          actions::MoveLayer{row.layer, static_cast<int>(place) - static_cast<int>(grip.value)});
    }
    ui.opens_context_menu(kOrderMenu);
  }
  ui.same_line(ui.px(kBeforeEye));
  const bool shows = row.look.is_visible;
  const std::string title(layer_title(row.layer));
  if (const auto on = ui.eye("visible", shows, {(shows ? "Hide " : "Show ") + title, ""})) {
    asked.emplace_back(actions::ShowLayer{row.layer, *on ? Switch::kOn : Switch::kOff});
  }
  ui.opens_context_menu(kOrderMenu);
  ui.same_line(ui.px(kBeforeName));
  const bool is_empty = !row.why_empty.empty();
  ui.text(title, is_empty || !shows ? kit::TextLook::kMuted : kit::TextLook::kNormal);
  ui.hint({std::string(kHelps.at(static_cast<std::size_t>(row.layer))), ""});
  draw_order_menu(ui, model, place, asked);
  if (row.layer == Layer::kLegend && !is_empty) return;  // it is there or not
  ui.same_line();
  if (is_empty) {
    const double width = ui.text_width(row.why_empty, kit::TextLook::kMuted);
    ui.right_align(std::min(width, std::max(1.0, ui.room().width)));
    ui.cut_text(row.why_empty, kit::TextLook::kMuted);
    ui.hint({title + " shows nothing now: " + row.why_empty, ""});
    return;
  }
  const double gap = ui.px(kBetweenControls), swatch = ui.px(kSwatchWidth);
  const bool shows_colour = has_line_colour(row.layer) && columns.has_swatch;
  const bool shows_slider = columns.slider > 0.0;
  if (!shows_colour && !shows_slider) return ui.space(0.0);
  const double beside = shows_colour && shows_slider ? gap : 0.0;
  ui.right_align((shows_colour ? swatch : 0.0) + beside + columns.slider);
  if (shows_colour) {
    const auto no_label = ui.label_width(0.0);
    ui.next_width(swatch);
    draw_colour(ui, model, row, asked);
    if (!shows_slider) return;
    ui.same_line(gap);
  }
  draw_opacity(ui, row, columns.slider, asked);
}

/// Three letters and "%" at most: "37 %", "4.2 %".
std::string share_text(double share) {
  constexpr double kFewPercent = 9.95;
  const double percent = share * kPercentOfLayer;
  return fmt::format("{:.{}f} %", percent, percent < kFewPercent ? 1 : 0);
}

void draw_class_shares(kit::Ui& ui, const LayersModel& model) {
  const auto section = ui.section(
      "Classes", true, model.classes.empty() ? "" : fmt::format("{}", model.classes.size()));
  if (!section) return;
  if (model.classes.empty()) {
    ui.text("No map is open", kit::TextLook::kMuted);
    return;
  }
  const std::array<kit::Column, 2> columns = {kit::Column{"class"}, kit::Column{"share"}};
  kit::TableOptions options;
  options.has_header = false;
  options.is_only_read = true;
  const auto table = ui.table("shares", columns, options);
  if (!table) return;
  for (const LayersModel::ClassShare& of_class : model.classes) {
    const std::string name(class_info(of_class.id).name);
    ui.row(name);
    ui.cell(name);
    ui.bar_cell(of_class.share, class_colour(of_class.id), share_text(of_class.share));
  }
}

}  // namespace

std::string_view layer_title(Layer layer) { return kTitles.at(static_cast<std::size_t>(layer)); }

bool has_line_colour(Layer layer) {
  return layer == Layer::kOdometry || layer == Layer::kTruth || layer == Layer::kEstimate ||
         layer == Layer::kEllipses || layer == Layer::kGraticule;
}

Rgba usual_line_colour(Layer layer, const LayersModel& model, const Theme& theme) {
  switch (layer) {
    case Layer::kOdometry:
      return model.is_on_picture ? theme.odometry_on_imagery : theme.odometry;
    case Layer::kTruth:
      return model.is_on_picture ? theme.truth_on_imagery : theme.truth;
    case Layer::kGraticule:
      return graticule_colour(model.is_on_picture, theme);
    default:
      return model.is_on_picture ? run_colour_on_imagery(theme, model.run_colour)
                                 : run_colour(theme, model.run_colour);
  }
}

Actions draw_layers(kit::Ui& ui, const LayersModel& model, LayersState& /*state*/) {
  Actions asked;
  const auto scope = ui.scope("Layers");
  const auto area = ui.scroll_area("Layers area");
  const LayerColumns columns = columns_for(ui, model);
  for (std::size_t place = 0; place < model.rows.size(); ++place)
    draw_layer_row(ui, model, columns, place, asked);
  ui.space();
  {
    const std::array<std::string, 3> poses = {"estimate", "truth", "odometry"};
    const auto above = ui.label_width(0.0);
    const auto pose = ui.choice("topview at", poses, static_cast<std::size_t>(model.topview_at),
                                {"Pose at which the topview lies on the map", ""});
    if (pose) asked.emplace_back(actions::LayTopview{static_cast<PoseSource>(*pose)});
  }
  ui.space();
  draw_class_shares(ui, model);
  return asked;
}

}  // namespace nadir
