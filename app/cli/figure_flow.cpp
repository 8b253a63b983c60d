// SPDX-License-Identifier: Apache-2.0
#include "app/cli/figure_flow.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/base/staged_output.h"
#include "widgets/canvas/fonts.h"
#include "widgets/canvas/png_file.h"
#include "widgets/canvas/svg_canvas.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/film.h"

namespace nadir::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecipeKey = "nadir-recipe";

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

std::optional<PageFile> page_file(const std::string& ending) {
  if (ending == ".png") return PageFile::kPng;
  if (ending == ".svg") return PageFile::kSvg;
  if (ending == ".pdf") return PageFile::kPdf;
  return std::nullopt;
}

/// Before the work, so that a machine without fonts is told at once; hashes only where there are some to compare with.
Result<FigureNotes> notes_on(const FigureRecipe& recipe,
                             FigureSources& sources,
                             const WorkContext& work) {
  auto notes = check_fonts();
  if (!notes) return notes;
  const InputHashes& then = recipe.inputs;
  if (then.runs.empty() && then.map.empty() && then.picture.empty() && then.route.empty())
    return notes;
  const auto now = hash_inputs(recipe, sources, work);
  if (!now) return forward_error(now);
  for (std::string& sentence : changed_inputs(recipe, *now)) notes->push_back(std::move(sentence));
  return notes;
}

Result<void> draw_film(const FigureRecipe& recipe,
                       const fs::path& path,
                       FigureSources& sources,
                       const WorkContext& work) {
  const auto known = figure_kind(recipe.figure);
  if (!known) return forward_error(known);
  const auto figure = make_figure(recipe, sources, work);
  if (!figure) return forward_error(figure);
  FigureContext context(page_format(recipe.options, known->aspect));
  context.supersampling = 1;
  const FilmOptions film{recipe.options.fps, recipe.options.speed, recipe.options.from_s,
                         recipe.options.to_s};
  const auto written = write_film(**figure, context, film, path, work);
  if (!written) return forward_error(written);
  return {};
}

}  // namespace

Result<FigureNotes> write_figure(const FigureRecipe& recipe,
                                 const fs::path& path,
                                 const WorkContext& work) {
  const std::string ending = ending_of(path);
  const auto kind = page_file(ending);
  if (!kind && ending != ".mp4") {
    return fail(ErrorCode::kInvalidOptions, "--out: {} does not end in .png, .svg, .pdf or .mp4",
                path.string());
  }
  if (const auto free = StagedOutput::file(path); !free) return forward_error(free);
  FigureSources sources;
  auto notes = notes_on(recipe, sources, work);
  if (!notes) return notes;
  if (!kind) {
    if (auto drawn = draw_film(recipe, path, sources, work); !drawn) return forward_error(drawn);
    return notes;
  }
  const auto bytes = draw_recipe(recipe, *kind, sources, work);
  if (!bytes) return forward_error(bytes);
  if (auto written = write_text_file(path, *bytes); !written) return forward_error(written);
  return notes;
}

Result<FigureNotes> stream_figure(const FigureRecipe& recipe,
                                  std::ostream& out,
                                  const WorkContext& work) {
  FigureSources sources;
  auto notes = notes_on(recipe, sources, work);
  if (!notes) return notes;
  const auto bytes = draw_recipe(recipe, PageFile::kPng, sources, work);
  if (!bytes) return forward_error(bytes);
  out << *bytes << std::flush;
  if (!out) return fail(ErrorCode::kIo, "standard output cannot be written");
  return notes;
}

Result<FigureRecipe> stored_recipe(const fs::path& path) {
  std::string text;
  if (ending_of(path) == ".svg") {
    const auto svg = read_text_file(path);
    if (!svg) return forward_error(svg);
    text = svg_metadata(*svg);
  } else if (ending_of(path) == ".pdf" || ending_of(path) == ".mp4") {
    return fail(ErrorCode::kUnsupported, "{}: only PNG and SVG figures carry their recipe",
                path.string());
  } else {
    const auto texts = read_png_texts(path);
    if (!texts) return forward_error(texts);
    const auto found = texts->find(kRecipeKey);
    if (found != texts->end()) text = found->second;
  }
  if (text.empty()) {
    return fail(ErrorCode::kMalformed,
                "{}: carries no recipe: Nadir has not drawn it, or its recipe was taken out",
                path.string());
  }
  return parse_figure_recipe(text, path.string());
}

}  // namespace nadir::cli
