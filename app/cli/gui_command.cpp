// SPDX-License-Identifier: Apache-2.0
#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/figure_flow.h"
#include "app/cli/map_subcommands.h"
#include "app/gui/child_process.h"
#include "app/gui/run_gui.h"
#include "core/base/field.h"
#include "widgets/figures/page_size.h"

namespace nadir::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGuiName = "nadir gui";

struct GuiArguments {
  GuiRequest request;
  std::string script, screenshot, size, scale, config;
  bool is_fresh = false;
};

void add_window_options(CLI::App& app, GuiArguments& values) {
  app.add_flag("--fresh", values.is_fresh,
               "Open nothing by itself, and leave what was open last for the next start without "
               "this");
  app.add_option("--size", values.size, "Of the window [px], default 1280x800")
      ->type_name("WIDTHxHEIGHT");
  app.add_option("--scale", values.scale,
                 "Of text and controls, 0.75 to 3; default the preference's")
      ->type_name("NUMBER");
  app.add_option("--config", values.config,
                 "For preferences and the last session, default ~/.config/nadir; with --script or "
                 "--screenshot one for this time only")
      ->type_name("FOLDER");
  app.add_option("--script", values.script,
                 "Do what a file says, an action a line, without a display")
      ->type_name("FILE");
  app.add_option("--screenshot", values.screenshot,
                 "Photograph the window as PNG when it has come to rest, without a display")
      ->type_name("FILE");
}

void add_arguments(CLI::App& app, GuiArguments& values) {
  app.add_option(
      "FILE", values.request.files,
      "Runs, maps, flights, recipes or figures to open; without any, what was open last");
  add_window_options(app, values);
  app.footer(
      "Example: nadir gui run.nadir\n"
      "Without a display: nadir gui run.nadir --screenshot window.png");
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets any
  return value == nullptr ? std::string() : value;
}

/// $NAME/nadir, else ~/FALLBACK/nadir.
fs::path folder_of_user(const char* name, const char* fallback) {
  const std::string given = variable(name);
  if (!given.empty() && fs::path(given).is_absolute()) return fs::path(given) / "nadir";
  const std::string home = variable("HOME");
  return (home.empty() ? fs::temp_directory_path() : fs::path(home) / fallback) / "nadir";
}

/// A folder that goes with the program.
class FolderForOnce {
 public:
  /// Where none can be made, nothing is kept.
  FolderForOnce() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "nadir-XXXXXX").string();
    if (!error && ::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~FolderForOnce() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  FolderForOnce(const FolderForOnce&) = delete;
  FolderForOnce& operator=(const FolderForOnce&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Result<void> take_size(const std::string& text, GuiRequest& request) {
  if (text.empty()) return {};
  const auto size = PageSize::from_text(text);
  if (!size) return forward_error(size, "--size");
  if (size->height == 0) {
    return fail(ErrorCode::kInvalidOptions, "--size: '{}' has no height (1280x800)", text);
  }
  constexpr int kLeast = 320;
  constexpr int kMost = 8192;
  for (const int side : {size->width, size->height}) {
    if (side < kLeast || side > kMost) {
      return fail(ErrorCode::kInvalidOptions, "--size: {} is not in [{}, {}]", side, kLeast, kMost);
    }
  }
  request.width = size->width;
  request.height = size->height;
  return {};
}

int run_window(CLI::App& app,
               GuiArguments& values,
               std::span<const std::string> arguments,
               std::ostream& out,
               std::ostream& err) {
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;
  GuiRequest& request = values.request;
  if (const auto size = take_size(values.size, request); !size) {
    return report_flags_error(err, app.get_name().c_str(), size.error());
  }
  if (!values.scale.empty()) {
    const auto scale = detail::parse_number(Field{"scale", "", "", 0.75, 3.0}, values.scale);
    if (!scale) return report_flags_error(err, app.get_name().c_str(), scale.error());
    if (const auto valid = detail::check_range(Field{"scale", "", "", 0.75, 3.0}, *scale); !valid) {
      return report_flags_error(err, app.get_name().c_str(), valid.error());
    }
    request.scale = *scale;
  }
  request.program = own_program();
  request.restores = !values.is_fresh;
  request.places.keeps_session = !values.is_fresh;
  if (!values.script.empty()) request.script = values.script;
  if (!values.screenshot.empty()) request.screenshot = values.screenshot;
  const bool is_unseen = request.script || request.screenshot;
  // What nobody sees must not change what somebody left open.
  std::optional<FolderForOnce> own_config;
  if (is_unseen && values.config.empty()) own_config.emplace();
  request.places.config = own_config              ? own_config->path()
                          : values.config.empty() ? folder_of_user("XDG_CONFIG_HOME", ".config")
                                                  : fs::absolute(values.config);
  request.places.data = folder_of_user("XDG_DATA_HOME", ".local/share");
  request.places.bundled_map = find_bundled("maps/proving-ground");
  request.places.resources = find_bundled("resources/profiles").parent_path();
  request.places.author = author_name();
  request.places.recipe_in_figure = [](const fs::path& figure) -> Result<std::string> {
    const auto recipe = stored_recipe(figure);
    if (!recipe) return forward_error(recipe);
    return recipe_text(*recipe);
  };
  if (!request.labels.empty()) {
    request.labels = fs::absolute(find_bundled(request.labels)).lexically_normal().string();
  }
  for (std::string& file : request.files) file = fs::absolute(file).lexically_normal().string();
  int status = kDone;  // of what was opened; nobody reads a notice in a window that nobody sees
  const auto done =
      is_unseen
          ? run_gui_unseen(request, [&](const Error& error) { status = report_error(err, error); })
          : run_desktop_gui(request);
  if (done) return status;
  status = report_error(err, done.error());
  if (arguments.empty()) err << "'nadir --help' lists the commands that need no display\n";
  return status;
}

}  // namespace

int run_gui(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Opens the window: replay runs, see why, run again, compare", kGuiName);
  GuiArguments values;
  add_arguments(app, values);
  return run_window(app, values, arguments, out, err);
}

int run_label(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Opens the window to draw labels on a map or an overhead image", "nadir label");
  GuiArguments values;
  app.add_option("MAP", values.request.labels,
                 "Map package, overhead image with a georeference, or labelling document")
      ->required();
  add_window_options(app, values);
  app.footer(
      "Every stroke is on disk at once: in labels.gpkg of the map, or IMAGE.labels.gpkg\n"
      "beside an image. 'nadir map export' then writes labels.tif.\n\n"
      "Example: nadir label maps/proving-ground");
  return run_window(app, values, arguments, out, err);
}

}  // namespace nadir::cli
