#include "app/desk.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "studio/paint_layers.h"

namespace luminist {
namespace {

constexpr std::size_t kMostMessages = 100;

void show(Desk& desk, Channel channel) {
  desk.channel = channel;
  desk.wipe = false;
  desk.orbit = false;
}

void keep_picture(Desk& desk) {
  if (!desk.has_shot()) return;
  desk.kept = desk.now->picture;
  desk.wipe_kept = true;
  desk.tell(StudioMessage::Kind::kNote, "the picture is kept; Wipe compares it with the light");
}

void accept(Desk& desk) {
  if (!desk.now->proposal) return;
  desk.studio->act("accept the lights", [](Session& session) { return session.accept(); });
}

void set_opacity(Desk& desk, int digit) {
  desk.box.set_opacity(digit == 0 ? 1.0F : 0.1F * static_cast<float>(digit));
}

/// Handles that stand aside come back first.
void toggle_handles(Desk& desk) {
  if (!std::exchange(desk.handles_aside, false)) desk.shape_handles = !desk.shape_handles;
}

void toggle_goal(Desk& desk, DragGoal goal) {
  desk.goal = desk.goal == goal ? DragGoal::kNone : goal;
  desk.orbit = false;
}

/// What concerns the brush and the view only. returns whether it was such a deed.
bool perform_here(Desk& desk, Deed deed, int digit) {
  constexpr float kBrushStep = 1.15F;
  switch (deed) {
    case Deed::kBrushSmaller:
      return desk.box.scale_diameter(1.0F / kBrushStep), true;
    case Deed::kBrushLarger:
      return desk.box.scale_diameter(kBrushStep), true;
    case Deed::kSwapColors:
      return desk.box.swap_colors(), true;
    case Deed::kDefaultColors:
      return desk.box.default_colors(), true;
    case Deed::kToolLight:
      return desk.box.take(Tool::kLight), true;
    case Deed::kToolErase:
      return desk.box.take(Tool::kErase), true;
    case Deed::kToolShadow:
      return desk.box.take(Tool::kShadow), true;
    case Deed::kToolImportance:
      return desk.box.take(Tool::kImportance), true;
    case Deed::kToolPick:
      return desk.box.take(Tool::kPick), true;
    case Deed::kToolEdit:
      return desk.box.take(Tool::kEdit), true;
    case Deed::kOpacity:
      return set_opacity(desk, digit), true;
    case Deed::kViewLight:
      return show(desk, Channel::kLight), true;
    case Deed::kViewPaint:
      return show(desk, Channel::kPaint), true;
    case Deed::kViewResidual:
      return show(desk, Channel::kResidual), true;
    case Deed::kViewImportance:
      return show(desk, Channel::kImportance), true;
    case Deed::kWipe:
      return desk.wipe = !desk.wipe, true;
    case Deed::kKeep:
      return keep_picture(desk), true;
    case Deed::kOrbit:
      return desk.orbit = !desk.orbit, true;
    case Deed::kDragHighlight:
      return toggle_goal(desk, DragGoal::kHighlight), true;
    case Deed::kDragShadow:
      return toggle_goal(desk, DragGoal::kShadow), true;
    case Deed::kHandles:
      return toggle_handles(desk), true;
    case Deed::kFit:
      return desk.view.fit(), true;
    case Deed::kFullSize:
      return desk.view.zoom_to(1.0F, desk.view.rect().center()), true;
    case Deed::kHidePanels:
      return desk.show_panels = !desk.show_panels, true;
    default:
      return false;
  }
}

}  // namespace

std::string Desk::with_key(const std::string& text, Deed deed) const {
  const std::string key = keys().key_of(deed);
  return key.empty() ? text : text + " (" + key + ")";
}

void Desk::see(std::shared_ptr<const StudioSnapshot> latest) {
  const auto place = [](const StudioSnapshot& snapshot) {
    return snapshot.frames ? Vantage{snapshot.frames->camera, snapshot.frames->frame} : Vantage{};
  };
  if (now && place(*now) != place(*latest)) selected_stroke = pointed_stroke = 0;
  now = std::move(latest);
}

void Desk::hush() {
  if (!messages.empty()) messages.back().time = -std::numeric_limits<double>::infinity();
}

const KeptStroke* Desk::edited_stroke() const {
  const auto found = now->layers->strokes.find(selected_stroke);
  return found == now->layers->strokes.end() ? nullptr : found->second.get();
}

void Desk::tell(StudioMessage::Kind kind, std::string text) {
  messages.push_back({{kind, std::move(text), "", ""}, time});
  while (messages.size() > kMostMessages) messages.pop_front();
}

void add_light(Desk& desk, bool only_first) {
  if (!desk.has_shot()) return;
  NewLight wanted;
  wanted.dark = true;
  desk.studio->act("add a light", [wanted, only_first](Session& session) -> Result<void> {
    if (only_first && !session.state().rig.lights.empty()) return {};
    if (session.has_proposal()) LUM_TRY_VOID(session.accept());
    LUM_TRY_VOID(session.add_light(wanted));
    return {};
  });
  desk.selected = desk.now->shown->rig.unused_name(wanted.name);
  if (desk.box.tool() != Tool::kLight) desk.box.take(Tool::kLight);
}

void save(Desk& desk) {
  if (!desk.has_shot()) return;
  if (desk.now->history.unsaved) return desk.ask(Question::kSaveAs);
  desk.studio->act_patiently("save", [studio = desk.studio](Session& session) -> Result<void> {
    LUM_TRY_VOID(session.save());
    studio->tell({StudioMessage::Kind::kNote, "saved to " + session.project().folder().string(), "", ""});
    return {};
  });
}

void delete_stroke(Desk& desk) {
  if (desk.box.tool() != Tool::kEdit || desk.edited_stroke() == nullptr) return;
  desk.studio->repaint("delete a stroke", [stroke = std::exchange(desk.selected_stroke, 0)](Session& session) {
    return session.layers().remove_stroke(stroke);
  });
}

void perform(Desk& desk, Deed deed, int digit) {
  if (deed == Deed::kOpen) return desk.ask(Question::kOpen);
  if (deed == Deed::kQuit) return desk.ask(Question::kQuit);
  if (deed == Deed::kKeys) return desk.ask(Question::kKeys);
  if (perform_here(desk, deed, digit) || !desk.has_shot()) return;
  desk.hush();
  StudioThread& studio = *desk.studio;
  switch (deed) {
    case Deed::kUndo:
      return studio.act_in_series(
          "undo", [](Session& session) { return session.undo(); }, Workbench::After::kFollow);
    case Deed::kRedo:
      return studio.act_in_series(
          "redo", [](Session& session) { return session.redo(); }, Workbench::After::kFollow);
    case Deed::kSave:
      return save(desk);
    case Deed::kSaveAs:
      return desk.ask(Question::kSaveAs);
    case Deed::kSolve:
      return studio.post("solve", [](Workbench& bench) { return bench.start_solve({}); });
    case Deed::kStop:
      return studio.cancel();
    case Deed::kAccept:
      return accept(desk);
    case Deed::kRevert:
      if (desk.now->proposal) studio.act("revert the lights", [](Session& session) { return session.revert(); });
      return;
    case Deed::kAddLight:
      return add_light(desk);
    case Deed::kDeleteStroke:
      return delete_stroke(desk);
    default:
      return;
  }
}

}  // namespace luminist
