#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/panels.h"

namespace luminist {
namespace {

/// "error 0.0626, was 0.0989", and what else a solve minds.
std::string error_line(const StudioSnapshot& now) {
  if (!now.report || !std::isfinite(now.report->epsilon)) return "";
  const SolveReport& report = *now.report;
  const char* outside = report.outside() ? "; a number is outside its range" : "";
  if (!std::isfinite(report.epsilon_start)) return fmt::format("error {:.4f}{}", report.error(), outside);
  return fmt::format("error {:.4f}, was {:.4f}{}", report.error(), report.error_start(), outside);
}

std::string state_line(const Desk& desk) {
  const StudioSnapshot& now = *desk.now;
  if (now.solving) return "Looking for better lights ...";
  if (now.proposal) return "These lights are a proposal: accept them, or paint on.";
  if (!now.any_paint) return "Nothing is painted.";
  if (now.free_dofs == 0) return "Everything is locked: add a light, or free one.";
  return now.live ? "Paint, and the lights follow." : "Painted. Solve to find the lights.";
}

/// The best error over the work so far, as a small curve.
void convergence(const Desk& desk) {
  if (!desk.now->report || desk.now->report->convergence.size() < 2) return;
  const std::vector<ConvergencePoint>& points = desk.now->report->convergence;
  const ImVec2 size(ImGui::GetContentRegionAvail().x, desk.theme.px(44.0F));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("convergence", size);
  tip(desk.theme, "The best error over the work so far; both axes are logarithmic.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, IM_COL32(32, 32, 32, 255), desk.theme.px(3.0F));
  double most = 0.0;
  double least = 1e30;
  for (const ConvergencePoint& point : points) {
    if (!std::isfinite(point.epsilon) || point.epsilon <= 0.0) continue;
    most = std::max(most, point.epsilon);
    least = std::min(least, point.epsilon);
  }
  const double work = std::log1p(points.back().render_equivalents);
  const double range = std::log(std::max(most / least, 1.02));
  if (!(work > 0.0)) return;
  for (const ConvergencePoint& point : points) {
    const double x = std::log1p(point.render_equivalents) / work;
    const double y = std::clamp(std::log(most / std::max(point.epsilon, least)) / range, 0.0, 1.0);
    list.PathLineTo(
        {at.x + 4.0F + static_cast<float>(x) * (size.x - 8.0F), at.y + 4.0F + static_cast<float>(y) * (size.y - 8.0F)});
  }
  list.PathStroke(paint_colors::kAccent, 0, 1.5F);
}

void dimmed_unless(bool enabled) {
  if (!enabled) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4F * ImGui::GetStyle().Alpha);
}

bool button(const Desk& desk, const char* label, bool enabled, float width, const std::string& words) {
  dimmed_unless(enabled);
  const bool clicked = ImGui::Button(label, {width, 0.0F});
  if (!enabled) ImGui::PopStyleVar();
  tip(desk.theme, words.c_str());
  return clicked && enabled;
}

ImU32 color_of(StrokeOutcome outcome) {
  switch (outcome) {
    case StrokeOutcome::kMet:
      return paint_colors::kGood;
    case StrokeOutcome::kMissed:
    case StrokeOutcome::kConflicting:
      return paint_colors::kWarn;
    default:
      return paint_colors::kBad;
  }
}

void stroke_verdict(Desk& desk, const StrokeVerdict& stroke) {
  ImGui::PushID(static_cast<int>(stroke.stroke));
  ImGui::BeginGroup();
  ImGui::PushStyleColor(ImGuiCol_Text, color_of(stroke.outcome));
  ImGui::TextWrapped("%s: %s", stroke.label.c_str(), to_string(stroke.outcome));
  ImGui::PopStyleColor();
  if (!stroke.text.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
    ImGui::TextWrapped("%s", stroke.text.c_str());
    ImGui::PopStyleColor();
  }
  if (stroke.remedy.kind != Remedy::Kind::kNone) {
    const std::uint32_t id = stroke.stroke;
    if (ImGui::Button("Do this")) {
      desk.studio->act(
          "do what the verdict advises", [id](Session& session) { return session.apply_remedy(id); },
          Workbench::After::kFollow);
    }
    ImGui::SameLine();
    ImGui::TextWrapped("%s", stroke.remedy.text.c_str());
  }
  ImGui::EndGroup();
  if (ImGui::IsItemHovered()) desk.pointed_stroke = stroke.stroke;
  ImGui::Spacing();
  ImGui::PopID();
}

}  // namespace

ImU32 outcome_color(StrokeOutcome outcome) {
  return color_of(outcome);
}

void solve_panel(Desk& desk) {
  const StudioSnapshot& now = *desk.now;
  ImGui::PushStyleColor(ImGuiCol_Text, now.solving || now.proposal ? paint_colors::kText : paint_colors::kDim);
  ImGui::TextWrapped("%s", state_line(desk).c_str());
  ImGui::PopStyleColor();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float third = (ImGui::GetContentRegionAvail().x - 2.0F * gap) / 3.0F;
  if (now.solving) {
    if (button(desk, "Stop", true, third, desk.with_key("Keep the best lights so far", Deed::kStop))) {
      perform(desk, Deed::kStop);
    }
  } else if (button(desk, "Solve", now.any_paint && now.free_dofs > 0, third,
                    desk.with_key("Look for the lights with all there is, not only while you paint", Deed::kSolve))) {
    perform(desk, Deed::kSolve);
  }
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Button,
                        now.proposal ? IM_COL32(150, 106, 52, 255) : ImGui::GetColorU32(ImGuiCol_Button));
  if (button(desk, "Accept", now.proposal, third,
             desk.with_key("These lights stay; their picture is what you paint on next", Deed::kAccept))) {
    perform(desk, Deed::kAccept);
  }
  ImGui::PopStyleColor();
  ImGui::SameLine();
  if (button(desk, "Revert", now.proposal, third,
             desk.with_key("Back to the lights from before; the paint stays", Deed::kRevert))) {
    perform(desk, Deed::kRevert);
  }
  bool live = now.live;
  if (ImGui::Checkbox("Lights follow the brush", &live)) {
    desk.studio->post("follow", [live](Workbench& bench) -> Result<void> {
      bench.set_live(live);
      return {};
    });
  }
  tip(desk.theme, "The solver works while you paint. Off: paint first, solve then.");
  const std::string line = error_line(now);
  if (!line.empty()) ImGui::TextDisabled("%s", line.c_str());
  convergence(desk);
}

void verdict_panel(Desk& desk) {
  const StudioSnapshot& now = *desk.now;
  if (!now.proposal) return ImGui::TextWrapped("Paint and solve; then every stroke can be judged.");
  if (ImGui::Button("Judge the strokes", {-1.0F, 0.0F})) {
    desk.studio->post("judge the strokes; Esc stops", [studio = desk.studio](Workbench& bench) {
      return bench.judge([studio] { return studio->undisturbed(); });
    });
  }
  tip(desk.theme,
      "Says of every stroke whether the lights make it, why not, and what would help. Takes seconds; Esc, or whatever "
      "you do next, takes it away.");
  if (!now.verdict) return;
  ImGui::Spacing();
  for (const StrokeVerdict& stroke : now.verdict->strokes) stroke_verdict(desk, stroke);
}

}  // namespace luminist
