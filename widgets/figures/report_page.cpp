// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/report_page.h"

#include <fmt/format.h>

#include <cctype>

#include "core/base/require.h"
#include "core/base/version.h"
#include "widgets/canvas/printable.h"

namespace nadir {
namespace {

std::string hex(Rgba colour) {
  return fmt::format("#{:02X}{:02X}{:02X}", colour.red, colour.green, colour.blue);
}

/// Figures have the colours of one theme, so the page has them too, whatever the reader's system prefers.
std::string style_of(ThemeName name) {
  const Theme& colours = theme(name);
  return fmt::format(
      ":root {{ color-scheme: {} }}\n"
      "body {{ font: 15px/1.5 Inter, 'DejaVu Sans', sans-serif; margin: 2rem auto; max-width: "
      "68rem; padding: 0 1rem; color: {}; background: {} }}\n"
      "h1 {{ font-size: 1.6rem; line-height: 1.2 }}\n"
      "h2 {{ font-size: 1.25rem; margin-top: 3rem; border-top: 1px solid {line}; padding-top: 1rem "
      "}}\nh3 {{ font-size: 1rem; margin: 0 }}\na {{ color: {} }}\n"
      "figure {{ margin: 2rem 0 }}\nfigcaption, .note {{ color: {muted} }}\n"
      "figcaption {{ margin-bottom: .5rem }}\n"
      "img {{ display: block; width: 100%; height: auto }}\n"
      "nav ul {{ list-style: none; padding: 0; margin: 0 }}\nnav li {{ margin: .25rem 0 }}\n"
      "nav a {{ margin-right: .75rem; white-space: nowrap }}\n"
      ".wide {{ overflow-x: auto; margin: 1.5rem 0 }}\n"
      "table {{ border-collapse: collapse; font-size: 13px; line-height: 1.4 }}\n"
      "caption {{ text-align: left; font-weight: 600; font-size: 15px; padding-bottom: .5rem }}\n"
      "th, td {{ text-align: left; padding: .25rem .6rem; vertical-align: top }}\n"
      "thead th {{ font-weight: 600; vertical-align: bottom }}\n"
      "tbody {{ border-top: 1px solid {line} }}\n"
      "td.number {{ text-align: right; font-family: 'JetBrains Mono', 'DejaVu Sans Mono', "
      "monospace; font-variant-numeric: tabular-nums }}\ntr.ratio {{ color: {muted} }}\n",
      name == ThemeName::kDark ? "dark" : "light", hex(colours.text), hex(colours.page),
      hex(colours.accent), fmt::arg("line", hex(colours.line)),
      fmt::arg("muted", hex(colours.muted)));
}

std::string page_title(std::span<const FigureRun> runs) {
  const RunHeader& header = runs.front().reader->header();
  const std::string first = fmt::format("{} on {}", header.flight, header.map);
  if (runs.size() == 1) return "Nadir report: " + first;
  return fmt::format("Nadir report: {} and {} more run{}", first, runs.size() - 1,
                     runs.size() > 2 ? "s" : "");
}

std::string figure_id(std::size_t i) { return fmt::format("figure-{}", i + 1); }

/// A line of links for each section.
std::string navigation(std::span<const PlannedFigure> figures) {
  if (figures.empty()) return {};
  std::string text = "<nav aria-label=\"Figures\">\n<ul>";
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const bool begins = i == 0 || figures[i].section != figures[i - 1].section;
    if (begins) {
      text += fmt::format("{}\n<li>{}: ", i == 0 ? "" : "</li>", markup_text(figures[i].section));
    }
    text +=
        fmt::format("<a href=\"#{}\">{}</a> ", figure_id(i), markup_text(figures[i].recipe.figure));
  }
  return text + "</li>\n</ul>\n</nav>\n";
}

std::string figure_markup(const PlannedFigure& figure, std::size_t i) {
  const std::string url = markup_text(url_path(figure.file));
  const std::string caption = markup_text(figure.caption);
  return fmt::format(
      "<figure id=\"{}\">\n<figcaption><h3>{}</h3>{} (<a href=\"{url}.png\">PNG</a>{})"
      "</figcaption>\n<a href=\"{url}.png\"><img src=\"{url}.png\" alt=\"{caption}\" "
      "loading=\"lazy\" /></a>\n</figure>\n",
      figure_id(i), markup_text(figure.recipe.figure), caption,
      figure.has_vectors ? fmt::format(", <a href=\"{}.svg\">SVG</a>", url) : "",
      fmt::arg("url", url), fmt::arg("caption", caption));
}

/// Of a run: where its facts are.
std::string section_heading(const std::string& section, std::span<const FigureRun> runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (section_of(runs[i]) != section) continue;
    return fmt::format("<h2><a href=\"#run-{}\">{}</a></h2>\n", i + 1, markup_text(section));
  }
  return "<h2>" + markup_text(section) + "</h2>\n";
}

std::string left_out_list(std::span<const std::string> left_out) {
  if (left_out.empty()) return {};
  std::string text = "<h2>Left out</h2>\n<ul>\n";
  for (const std::string& words : left_out) text += "<li>" + markup_text(words) + "</li>\n";
  return text + "</ul>\n";
}

}  // namespace

std::string url_path(std::string_view path) {
  constexpr std::string_view kPlain = "-._~/";
  std::string url;
  for (const char letter : path) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_plain =
        byte < 0x80U && (std::isalnum(byte) != 0 || kPlain.find(letter) != std::string_view::npos);
    url += is_plain ? std::string(1, letter) : fmt::format("%{:02X}", byte);
  }
  return url;
}

std::string report_page(const ReportContents& contents) {
  NADIR_REQUIRE(!contents.runs.empty());
  const std::string title = markup_text(page_title(contents.runs));
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n"
      "<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n",
      title, style_of(contents.theme));
  page += run_table(contents.runs) + error_table(contents.runs) + navigation(contents.figures);
  for (std::size_t i = 0; i < contents.figures.size(); ++i) {
    const PlannedFigure& figure = contents.figures[i];
    if (i == 0 || figure.section != contents.figures[i - 1].section) {
      page += section_heading(figure.section, contents.runs);
    }
    page += figure_markup(figure, i);
  }
  page += left_out_list(contents.left_out);
  return page +
         fmt::format(
             "<p class=\"note\">Drawn by Nadir {}. Numbers such as (4-4) are those of the figures "
             "of Rouben's thesis that show the same. Every PNG and SVG carries the recipe that "
             "draws it again: <code>nadir figure --recreate FILE --out AGAIN.png</code>.</p>\n"
             "</body>\n</html>\n",
             kVersion);
}

}  // namespace nadir
