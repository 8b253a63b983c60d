// SPDX-License-Identifier: Apache-2.0
#include "core/map/image_stack.h"

#include <fmt/format.h>

#include "core/base/settings.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNumbersAPoint = 4;
constexpr std::size_t kNumbersADistance = 7;

std::string list_of(const std::vector<double>& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string path_from(const fs::path& path, const fs::path& folder) {
  const fs::path relative = fs::absolute(path).lexically_normal().lexically_relative(
      fs::absolute(folder).lexically_normal());
  return (relative.empty() ? path : relative).generic_string();
}

std::string image_text(const StackedImage& image, const fs::path& folder) {
  std::string text = fmt::format("[[image]]\nname = {}\npath = {}\n", toml_quoted(image.name),
                                 toml_quoted(path_from(image.path, folder)));
  if (!image.crs.empty()) text += fmt::format("crs = {}\n", toml_quoted(image.crs));
  if (!image.control_points.empty()) {
    std::vector<double> numbers;
    std::vector<std::string> names;
    for (const ControlPoint& point : image.control_points) {
      numbers.insert(numbers.end(), {point.in_pixels.x(), point.in_pixels.y(), point.in_enu_m.x(),
                                     point.in_enu_m.y()});
      names.push_back(toml_quoted(point.name));
    }
    text += fmt::format("control_model = \"{}\"\ncontrol_points = {}\ncontrol_point_names = [{}]\n",
                        image.control_model == ControlModel::kAffine ? "affine" : "similarity",
                        list_of(numbers), fmt::join(names, ", "));
  }
  if (image.known_distance) {
    const KnownDistance& known = *image.known_distance;
    text += fmt::format("known_distance = {}\n",
                        list_of({known.from_in_pixels.x(), known.from_in_pixels.y(),
                                 known.to_in_pixels.x(), known.to_in_pixels.y(), known.distance_m,
                                 known.origin_in_enu_m.x(), known.origin_in_enu_m.y()}));
  }
  text += fmt::format("offset_in_enu_m = {}\n",
                      list_of({image.offset_in_enu_m.x(), image.offset_in_enu_m.y()}));
  text += fmt::format("is_visible = {}\nopacity = {}\nbrightness = {}\ncontrast = {}\n",
                      image.look.is_visible, image.look.opacity, image.look.brightness,
                      image.look.contrast);
  return text;
}

/// The numbers of a list that must have so many, or a multiple. @errors kMalformed.
Result<std::vector<double>> numbers_of(const Settings& table,
                                       const std::string& key,
                                       std::size_t count,
                                       bool is_multiple) {
  auto numbers = table.numbers(key);
  if (!numbers) return numbers;
  const bool fits = is_multiple ? numbers->size() % count == 0 : numbers->size() == count;
  if (fits) return numbers;
  return fail(ErrorCode::kMalformed, "{}: {} has {} numbers instead of {}{}", table.name(), key,
              numbers->size(), is_multiple ? "a multiple of " : "", count);
}

Result<double> number_within(
    const Settings& table, const std::string& key, double fallback, double low, double high) {
  auto value = table.number_or(key, fallback);
  if (!value || (*value >= low && *value <= high)) return value;
  return fail(ErrorCode::kMalformed, "{}: {} is {} and not in [{}, {}]", table.name(), key, *value,
              low, high);
}

Result<void> read_control_points(const Settings& table, StackedImage& image) {
  if (!table.has("control_points")) return {};
  const auto numbers = numbers_of(table, "control_points", kNumbersAPoint, true);
  if (!numbers) return forward_error(numbers);
  std::vector<std::string> names(numbers->size() / kNumbersAPoint);
  if (table.has("control_point_names")) {
    const auto written = table.texts("control_point_names");
    if (!written) return forward_error(written);
    if (written->size() != names.size()) {
      return fail(ErrorCode::kMalformed, "{}: {} control points have {} names", table.name(),
                  names.size(), written->size());
    }
    names = *written;
  }
  const auto model = table.text_or("control_model", "similarity");
  if (!model) return forward_error(model);
  if (*model != "similarity" && *model != "affine") {
    return fail(ErrorCode::kMalformed, "{}: control_model {} is neither similarity nor affine",
                table.name(), *model);
  }
  image.control_model = *model == "affine" ? ControlModel::kAffine : ControlModel::kSimilarity;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double* const at = numbers->data() + i * kNumbersAPoint;
    image.control_points.push_back(ControlPoint{{at[0], at[1]}, {at[2], at[3]}, names[i]});
  }
  return {};
}

Result<void> read_known_distance(const Settings& table, StackedImage& image) {
  if (!table.has("known_distance")) return {};
  const auto numbers = numbers_of(table, "known_distance", kNumbersADistance, false);
  if (!numbers) return forward_error(numbers);
  const std::vector<double>& at = *numbers;
  image.known_distance = KnownDistance{{at[0], at[1]}, {at[2], at[3]}, at[4], {at[5], at[6]}};
  return {};
}

Result<void> read_look(const Settings& table, ImageLook& look) {
  if (table.has("is_visible")) {
    const auto is_visible = table.boolean("is_visible");
    if (!is_visible) return forward_error(is_visible);
    look.is_visible = *is_visible;
  }
  const auto opacity = number_within(table, "opacity", 1.0, 0.0, 1.0);
  if (!opacity) return forward_error(opacity);
  const auto brightness = number_within(table, "brightness", 0.0, -1.0, 1.0);
  if (!brightness) return forward_error(brightness);
  const auto contrast = number_within(table, "contrast", 0.0, -1.0, 1.0);
  if (!contrast) return forward_error(contrast);
  look.opacity = *opacity;
  look.brightness = *brightness;
  look.contrast = *contrast;
  return {};
}

Result<StackedImage> read_stacked_image(const Settings& table, const fs::path& folder) {
  if (const auto known = table.refuse_unknown(
          {"name", "path", "crs", "control_model", "control_points", "control_point_names",
           "known_distance", "offset_in_enu_m", "is_visible", "opacity", "brightness", "contrast"});
      !known) {
    return forward_error(known);
  }
  StackedImage image;
  const auto path = table.text("path");
  if (!path) return forward_error(path);
  image.path = (folder / *path).lexically_normal();
  auto name = table.text_or("name", image.path.stem().string());
  if (!name) return forward_error(name);
  image.name = std::move(*name);
  auto crs = table.text_or("crs", "");
  if (!crs) return forward_error(crs);
  image.crs = std::move(*crs);
  if (table.has("offset_in_enu_m")) {
    const auto offset = numbers_of(table, "offset_in_enu_m", 2, false);
    if (!offset) return forward_error(offset);
    image.offset_in_enu_m = {offset->at(0), offset->at(1)};
  }
  for (const auto& read : {read_control_points(table, image), read_known_distance(table, image),
                           read_look(table, image.look)}) {
    if (!read) return forward_error(read);
  }
  return image;
}

}  // namespace

Result<ImageOptions> options_of(const StackedImage& image,
                                const ProjectPlane& plane,
                                const fs::path& cache) {
  ImageOptions options{.plane = plane, .crs = image.crs, .cache = cache};
  if (!image.control_points.empty()) {
    const auto fit = fit_control_points(image.control_points, image.control_model);
    if (!fit) return forward_error(fit, image.name);
    options.enu_from_pixels = fit->enu_from_pixels;
  } else if (image.known_distance) {
    const KnownDistance& known = *image.known_distance;
    const auto scale = scale_by_distance(known.from_in_pixels, known.to_in_pixels, known.distance_m,
                                         known.origin_in_enu_m);
    if (!scale) return forward_error(scale, image.name);
    options.enu_from_pixels = *scale;
  }
  return options;
}

std::string image_stack_text(const ImageStack& stack, const fs::path& folder) {
  std::string text;
  for (const StackedImage& image : stack.images) {
    if (!text.empty()) text += '\n';
    text += image_text(image, folder);
  }
  return text;
}

Result<ImageStack> parse_image_stack(std::string_view text,
                                     const fs::path& folder,
                                     const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  if (const auto known = settings->refuse_unknown({"image"}); !known) return forward_error(known);
  ImageStack stack;
  if (!settings->has("image")) return stack;
  const auto tables = settings->tables("image");
  if (!tables) return forward_error(tables);
  for (const Settings& table : *tables) {
    auto image = read_stacked_image(table, folder);
    if (!image) return forward_error(image);
    stack.images.push_back(std::move(*image));
  }
  return stack;
}

}  // namespace nadir
