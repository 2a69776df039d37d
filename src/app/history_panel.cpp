#include "app/icons.h"
#include "app/panels.h"

namespace luminist {

void history_panel(Desk& desk) {
  const HistoryFacts& history = desk.now->history;
  if (history.labels.empty()) return ImGui::TextDisabled("Nothing was done yet.");
  for (std::size_t i = history.labels.size(); i-- > 0;) {
    const std::size_t index = history.first + i;
    const bool undone = index >= history.undo_steps;
    const bool present = index + 1 == history.undo_steps;
    ImGui::PushID(static_cast<int>(index));
    ImGui::PushStyleColor(ImGuiCol_Text, undone ? paint_colors::kFaint : paint_colors::kText);
    if (ImGui::Selectable(history.labels[i].c_str(), present)) {
      const std::size_t wanted = index + 1;
      desk.studio->act(
          "go through the history",
          [wanted](Session& session) -> Result<void> {
            while (session.project().undo_steps() > wanted) LUM_TRY_VOID(session.undo());
            while (session.project().undo_steps() < wanted) LUM_TRY_VOID(session.redo());
            return {};
          },
          Workbench::After::kFollow);
    }
    ImGui::PopStyleColor();
    tip(desk.theme, undone ? "Undone. Click to go forward to here." : "Click to go back to here.");
    ImGui::PopID();
  }
}

}  // namespace luminist
