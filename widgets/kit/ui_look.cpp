// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_look.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nadir::kit {
namespace {

double linear(std::uint8_t channel) {
  const double value = channel / 255.0;
  return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double luminance(Rgba colour) {
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

ImVec4 as_vector(std::uint32_t packed_colour) {
  return ImGui::ColorConvertU32ToFloat4(packed_colour);
}

/// As strong as on the ground half of it.
std::uint32_t half_as_strong(std::uint32_t packed_colour) {
  return (packed_colour & ~IM_COL32_A_MASK) | (std::uint32_t{140} << IM_COL32_A_SHIFT);
}

}  // namespace

std::uint32_t packed(Rgba colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, colour.alpha);
}

Rgba mixed(Rgba a, Rgba b, double share) {
  const auto channel = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue), a.alpha};
}

double contrast(Rgba a, Rgba b) {
  const double first = luminance(a) + 0.05;
  const double second = luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

Look look_of(const Theme& theme) {
  const bool is_light = luminance(theme.page) > 0.5;
  // On white paper nothing is whiter: there only the line around it raises a button.
  const Rgba raised = is_light ? theme.page : mixed(theme.page, theme.line, 0.42);
  const Rgba white{255, 255, 255};
  Look look;
  look.window = packed(theme.window);
  look.panel = packed(theme.page);
  look.raised = packed(raised);
  look.hovered = packed(mixed(raised, theme.text, is_light ? 0.05 : 0.08));
  look.held = packed(mixed(raised, theme.text, is_light ? 0.10 : 0.14));
  look.plate = packed(with_opacity(theme.page, 0.85));
  look.line = packed(theme.line);
  look.text = packed(theme.text);
  look.muted = packed(theme.muted);
  look.faint = packed(mixed(theme.page, theme.line, 0.5));
  look.accent = packed(theme.accent);
  look.accent_hovered = packed(mixed(theme.accent, theme.text, 0.14));
  look.accent_soft = packed(with_opacity(theme.accent, is_light ? 0.13 : 0.20));
  look.on_accent = packed(
      contrast(white, theme.accent) >= contrast(theme.window, theme.accent) ? white : theme.window);
  look.good = packed(theme.good);
  look.warning = packed(theme.warning);
  look.bad = packed(theme.bad);
  look.dimming = packed({0, 0, 0, static_cast<std::uint8_t>(is_light ? 70 : 110)});
  return look;
}

void set_style(ImGuiStyle& style, const Look& look, double scale) {
  const auto d = [scale](double design) {
    return static_cast<float>(std::max(1.0, std::floor(design * scale + 0.5)));
  };
  style = ImGuiStyle();
  style.WindowPadding = {d(12), d(12)};
  style.WindowMinSize = {1.0F, 1.0F};
  style.FramePadding = {d(8), d(5)};
  style.ItemSpacing = {d(8), 0.0F};  // kit leaves the room between rows itself
  style.ItemInnerSpacing = {d(8), d(4)};
  style.CellPadding = {d(6), 0.0F};
  style.ScrollbarSize = d(10);
  style.GrabMinSize = d(10);
  style.WindowBorderSize = style.ChildBorderSize = style.FrameBorderSize = 0.0F;
  style.PopupBorderSize = 1.0F;
  style.WindowRounding = style.ChildRounding = 0.0F;
  style.FrameRounding = style.PopupRounding = style.GrabRounding = style.TabRounding = d(4);
  style.ScrollbarRounding = d(5);
  style.DisabledAlpha = 1.0F;  // kit pales what is disabled itself
  style.AntiAliasedLinesUseTex = false;
  style.CircleTessellationMaxError = 0.15F;
  const ImVec4 none(0.0F, 0.0F, 0.0F, 0.0F);
  struct Role {
    ImGuiCol role;
    std::uint32_t colour;
  };
  const std::array<Role, 22> roles = {{{ImGuiCol_Text, look.text},
                                       {ImGuiCol_TextDisabled, look.muted},
                                       {ImGuiCol_WindowBg, look.panel},
                                       {ImGuiCol_PopupBg, look.raised},
                                       {ImGuiCol_Border, look.line},
                                       {ImGuiCol_FrameBg, look.raised},
                                       {ImGuiCol_FrameBgHovered, look.hovered},
                                       {ImGuiCol_FrameBgActive, look.held},
                                       {ImGuiCol_ScrollbarGrab, half_as_strong(look.muted)},
                                       {ImGuiCol_ScrollbarGrabHovered, look.muted},
                                       {ImGuiCol_ScrollbarGrabActive, look.muted},
                                       {ImGuiCol_CheckMark, look.accent},
                                       {ImGuiCol_Button, look.raised},
                                       {ImGuiCol_ButtonHovered, look.hovered},
                                       {ImGuiCol_ButtonActive, look.held},
                                       {ImGuiCol_Header, look.accent_soft},
                                       {ImGuiCol_HeaderHovered, look.hovered},
                                       {ImGuiCol_HeaderActive, look.held},
                                       {ImGuiCol_TableBorderLight, look.line},
                                       {ImGuiCol_TableBorderStrong, look.line},
                                       {ImGuiCol_TextSelectedBg, look.accent_soft},
                                       {ImGuiCol_DragDropTarget, look.accent}}};
  for (const Role& role : roles) style.Colors[role.role] = as_vector(role.colour);
  for (const ImGuiCol role : {ImGuiCol_ChildBg, ImGuiCol_ScrollbarBg, ImGuiCol_BorderShadow,
                              ImGuiCol_TableHeaderBg, ImGuiCol_TableRowBg, ImGuiCol_TableRowBgAlt,
                              ImGuiCol_NavHighlight, ImGuiCol_MenuBarBg, ImGuiCol_ResizeGrip}) {
    style.Colors[role] = none;
  }
}

}  // namespace nadir::kit
