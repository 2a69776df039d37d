// One rig for several frames, in the panel of shots.
#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/shots_panel.h"
#include "params/param_text.h"
#include "studio/shot_view.h"
#include "studio/shots.h"

namespace luminist {
namespace {

/// "2 met, 1 missed", and what of each as a tooltip.
std::pair<std::string, std::string> verdict_words(const Verdict& verdict) {
  std::map<std::string, int> counts;
  std::string all;
  for (const StrokeVerdict& stroke : verdict.strokes) {
    ++counts[to_string(stroke.outcome)];
    all += fmt::format("{}{}: {}{}{}", all.empty() ? "" : "\n", stroke.label, to_string(stroke.outcome),
                       stroke.text.empty() ? "" : "; ", stroke.text);
  }
  std::string words;
  for (const auto& [word, count] : counts) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, word);
  return {words, all};
}

/// Shows the lights that a solve has found so far, a few times a second.
Shots::Look look_of(StudioThread* studio, Session& session) {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kBetween{250};
  return [studio, &session, shown = Clock::now()](const ParamState& lights) mutable -> Result<void> {
    if (Clock::now() - shown < kBetween) return {};
    LUM_TRY(Image picture, session.stage().renderer->render(lights));
    studio->show(std::make_shared<const Image>(std::move(picture)), std::make_shared<const ParamState>(lights));
    shown = Clock::now();
    return {};
  };
}

void solve(Desk& desk, const std::vector<FrameChoice>& choices, bool judge) {
  StudioThread* studio = desk.studio;
  studio->act("solve frames together", [studio, choices, judge](Session& session) -> Result<void> {
    if (session.has_proposal()) LUM_TRY_VOID(session.adopt());
    const auto watch = [studio, count = choices.size()](const SolveReport& report) {
      const bool solving = report.termination == Termination::kRunning;
      return studio->progress(solving ? fmt::format("{} together: error {:.4f}, was {:.4f}; Esc stops", count,
                                                    report.error(), report.error_start())
                                      : "judging the strokes; Esc stops");
    };
    return Shots(session).solve(choices, {}, judge, watch, look_of(studio, session));
  });
}

void go(const Desk& desk, const Vantage& present, const Vantage& at) {
  if (at.camera == present.camera) return desk.studio->go_to(at.frame);
  desk.studio->change("look through " + at.camera, [at](Session& session) { return session.view().look_through(at); });
}

}  // namespace

void ShotsPanel::choice_row(Desk& desk, const FrameFacts& facts, const PaintedFrame& painted) {
  const Theme& theme = desk.theme;
  Choice& choice = choices_[painted.at];
  const Vantage present{facts.camera, facts.frame};
  const std::string name = vantage_text(painted.at, desk.now->facts->cameras);
  ImGui::PushID(name.c_str());
  ImGui::Checkbox("##on", &choice.on);
  tip(theme, "Whether this paint takes part.");
  ImGui::SameLine(0.0F, theme.px(6.0F));
  ImGui::PushStyleColor(ImGuiCol_Text, painted.at == present ? paint_colors::kAccent : paint_colors::kText);
  const float width = std::max(theme.px(76.0F), ImGui::CalcTextSize(name.c_str()).x + theme.px(16.0F));
  if (ImGui::Button(name.c_str(),
                    {desk.now->facts->cameras.size() > 1 ? std::max(width, theme.px(150.0F)) : width, 0.0F})) {
    go(desk, present, painted.at);
  }
  ImGui::PopStyleColor();
  tip(theme, fmt::format("{} stroke{}. Click to go there, right click to clear.", painted.strokes,
                         painted.strokes == 1 ? "" : "s")
                 .c_str());
  clear_menu(desk, painted.at);
  ImGui::SameLine(0.0F, theme.px(6.0F));
  ImGui::SetNextItemWidth(theme.px(104.0F));
  ImGui::SliderFloat("##weight", &choice.weight, 0.1F, 10.0F, "weight %.2f",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  tip(theme, "How much the error of this picture counts among the others'. Ctrl+click to type a number.");
  const auto solved = std::find_if(facts.solved.begin(), facts.solved.end(),
                                   [&](const SolvedFrame& each) { return each.at == painted.at; });
  if (solved != facts.solved.end()) {
    ImGui::SameLine(0.0F, theme.px(10.0F));
    ImGui::AlignTextToFramePadding();
    const ImU32 color = solved->found <= solved->start ? paint_colors::kGood : paint_colors::kWarn;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::Text("%.4f", solved->found);
    ImGui::PopStyleColor();
    ImGui::SameLine(0.0F, theme.px(4.0F));
    ImGui::TextDisabled("was %.4f", solved->start);
    tip(theme, "The error of this picture under the lights that were found, and before.");
    if (solved->verdict) {
      const auto [words, all] = verdict_words(*solved->verdict);
      ImGui::SameLine(0.0F, theme.px(10.0F));
      ImGui::TextUnformatted(words.c_str());
      tip(theme, all.c_str());
    }
  }
  ImGui::PopID();
}

void ShotsPanel::together(Desk& desk, const FrameFacts& facts) {
  want(desk, 0);
  const Theme& theme = desk.theme;
  if (facts.painted.size() < 2) {
    ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
    ImGui::TextWrapped(
        "%s", facts.painted.empty()
                  ? "Paint on several frames, or through several cameras; then one rig can be found for all of them."
                  : "One frame is painted. Paint another one, too, or look through another camera and paint "
                    "there; then one rig can be found for both.");
    ImGui::PopStyleColor();
    return;
  }
  std::vector<FrameChoice> chosen;
  const float bottom = ImGui::GetFrameHeightWithSpacing() + theme.px(4.0F);
  ImGui::BeginChild("frames", {0.0F, ImGui::GetContentRegionAvail().y - bottom});
  for (const PaintedFrame& painted : facts.painted) {
    choice_row(desk, facts, painted);
    const Choice& choice = choices_[painted.at];
    if (choice.on) chosen.push_back({painted.at, static_cast<double>(choice.weight)});
  }
  ImGui::EndChild();
  const std::string obstacle = desk.now->free_dofs == 0 ? "everything is locked: free what may change"
                               : chosen.size() < 2      ? "choose two at least"
                                                        : "";
  const bool ready = obstacle.empty();
  if (!ready) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4F * ImGui::GetStyle().Alpha);
  const std::string label = fmt::format("Solve {} together", chosen.size());
  const bool clicked = ImGui::Button(label.c_str());
  if (!ready) ImGui::PopStyleVar();
  tip(theme,
      "Finds one rig for what is painted on the chosen frames and cameras: the weighted mean of their errors. "
      "Accepting it answers "
      "the paint of all. What has keys stays as they say. Takes a while.");
  if (clicked && ready) solve(desk, chosen, judge_);
  ImGui::SameLine();
  ImGui::Checkbox("judge the strokes", &judge_);
  tip(theme, "Afterwards says of every stroke whether the lights make it. Takes seconds for each picture.");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  if (!ready) {
    ImGui::TextDisabled("%s", obstacle.c_str());
  } else if (!facts.solved.empty() && desk.now->report) {
    ImGui::Text("together %.4f, was %.4f", desk.now->report->error(), desk.now->report->error_start());
    tip(theme, "The weighted mean of the errors, and what it was. Accept or revert it as any solve.");
  }
}

}  // namespace luminist
