#include "app/questions.h"

#include <fmt/format.h>

#include "app/icons.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

FileWish wish_for(const Desk& desk) {
  switch (desk.question) {
    case Question::kOpen:
      return {"Open a scene or a project",
              "Open",
              {".lum", ".glb", ".gltf", ".obj", ".ply", ".stl", ".off"},
              false,
              "",
              false};
    case Question::kSaveAs: {
      const std::string scene = desk.has_shot() ? fs::path(desk.now->facts->shot.scene).stem().string() : "shot";
      return {"Save the project as", "Save", {".lum"}, true, scene + ".lum", false};
    }
    case Question::kImage:
      return {"An image to copy from", "Choose", {".exr", ".png", ".jpg", ".hdr", ".tif"}, false, "", false};
    default:
      return {"Export into a folder", "Export", {}, true, "export", true};
  }
}

bool asks_for_file(Question question) {
  return question == Question::kOpen || question == Question::kSaveAs || question == Question::kImage ||
         question == Question::kExportFolder;
}

}  // namespace

void open_path(Desk& desk, const fs::path& path) {
  desk.selected.clear();
  desk.solo.clear();
  if (path.extension() == ".lum") {
    desk.studio->post("open " + path.filename().string(),
                      [path](Workbench& bench) { return bench.open_project(path); });
    return;
  }
  Shot shot;
  shot.scene = path.string();
  remember_file(path);
  // A bare mesh stands better with a floor under it.
  shot.scene_options.floor = shot.scene_options.wall = path.extension() != ".glb" && path.extension() != ".gltf";
  desk.studio->post("open " + path.filename().string(),
                    [shot](Workbench& bench) { return bench.open(shot, fs::current_path()); });
}

void Questions::begin(Desk& desk) {
  desk.question_asked = true;
  ImGui::OpenPopup("question");
  if (!asks_for_file(desk.question)) return;
  if (folder_.empty()) folder_ = fs::current_path();
  dialog_.open(wish_for(desk), folder_);
}

void Questions::answer(Desk& desk, const fs::path& path) {
  folder_ = dialog_.folder();
  switch (desk.question) {
    case Question::kOpen:
      open_path(desk, path);
      break;
    case Question::kSaveAs:
      desk.studio->post("save", [path, studio = desk.studio](Workbench& bench) -> Result<void> {
        LUM_TRY_VOID(bench.save_as(path));
        studio->tell({StudioMessage::Kind::kNote, "saved to " + path.string(), "", ""});
        return {};
      });
      break;
    case Question::kImage:
      desk.box.brush().copy_from = path.string();
      break;
    default:
      desk.studio->act("export", [path, choice = choice_, studio = desk.studio](Session& session) -> Result<void> {
        const auto watch = [studio](const std::string& next, int done, int all) {
          return studio->progress(fmt::format("export {} ({} of {}; Esc stops)", next, done + 1, all));
        };
        LUM_TRY(const auto files, export_pictures(session, choice, path, watch));
        studio->tell(
            {StudioMessage::Kind::kNote, fmt::format("{} files are in {}", files.size(), path.string()), "", ""});
        return {};
      });
  }
}

/// What is exported, before where to.
void Questions::choose_export(Desk& desk) {
  const Theme& theme = desk.theme;
  const auto tick = [&](const char* label, bool& on, const char* words) {
    ImGui::Checkbox(label, &on);
    tip(theme, words);
  };
  ImGui::PushFont(theme.strong);
  ImGui::TextUnformatted("Export");
  ImGui::PopFont();
  ImGui::Spacing();
  ImGui::Columns(2, "what", false);
  ImGui::TextDisabled("Pictures");
  tick("The light", choice_.light, "The shot as it is lit now: of a proposal, while there is one.");
  tick("The paint", choice_.paint, "What is painted, or what the last solve was for.");
  tick("The residual", choice_.residual, "Where light and paint differ, as a heat map over its scale.");
  tick("The importance", choice_.importance, "What counts most is black.");
  tick("Each light alone", choice_.each_light,
       "A picture for every light that is on, as solo shows it, and one without.");
  ImGui::NextColumn();
  ImGui::TextDisabled("Files");
  tick("PNG", choice_.png, "As the screen shows it at exposure 0, 8 bits a channel.");
  tick("EXR", choice_.exr, "Linear numbers, for compositing.");
  tick("A contact sheet", choice_.sheet, "All of these pictures small and side by side: sheet.png.");
  tick("Rig, style and materials", choice_.rig,
       "rig.toml, style.json and materials.json, with which the picture can be rendered again.");
  tick("The scene", choice_.scene, "scene.glb, with its materials as they are changed here, for other programs.");
  ImGui::Columns(1);
  ImGui::Spacing();
  const bool pictures = choice_.light || choice_.paint || choice_.residual || choice_.importance || choice_.each_light;
  const bool kinds = choice_.png || choice_.exr || choice_.sheet;
  ImGui::BeginDisabled(!choice_.rig && !choice_.scene && !(pictures && kinds));
  if (ImGui::Button("Choose a folder...", {theme.px(150.0F), 0.0F})) desk.ask(Question::kExportFolder);
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {theme.px(86.0F), 0.0F})) leave(desk);
}

void Questions::files(Desk& desk) {
  const auto chosen = dialog_.draw(desk.theme);
  if (chosen) answer(desk, *chosen);
  if (chosen || dialog_.left()) leave(desk);
}

void Questions::keys(Desk& desk) {
  ImGui::PushFont(desk.theme.strong);
  ImGui::Text("Keys, as in %s", desk.keys().name.c_str());
  ImGui::PopFont();
  ImGui::Spacing();
  if (ImGui::BeginTable("keys", 4)) {
    for (int pair = 0; pair < 2; ++pair) {
      ImGui::TableSetupColumn(pair == 0 ? "key" : "key 2", ImGuiTableColumnFlags_WidthFixed, desk.theme.px(96.0F));
      ImGui::TableSetupColumn(pair == 0 ? "deed" : "deed 2", ImGuiTableColumnFlags_WidthStretch);
    }
    for (int i = 1; i <= static_cast<int>(Deed::kOpacity); ++i) {
      const auto deed = static_cast<Deed>(i);
      const std::string key = desk.keys().key_of(deed);
      if (key.empty()) continue;
      ImGui::TableNextColumn();
      ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kAccent);
      ImGui::TextUnformatted(key.c_str());
      ImGui::PopStyleColor();
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(name_of(deed));
    }
    ImGui::EndTable();
  }
  ImGui::Spacing();
  const char* pick = desk.keys().name == "Photoshop" ? "Alt" : "Ctrl";
  ImGui::TextDisabled(
      "Drag: paint.   Shift+drag: size.   %s+click: pick a colour.   Space or middle drag: pan.   Wheel: zoom.", pick);
  ImGui::Spacing();
  if (ImGui::Button("Close", {desk.theme.px(86.0F), 0.0F})) leave(desk);
}

void Questions::quit(Desk& desk) {
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted("This session has no name yet");
  ImGui::PopFont();
  ImGui::TextUnformatted("What you did is kept, and offered when you start again.");
  ImGui::Spacing();
  const ImVec2 size(desk.theme.px(120.0F), 0.0F);
  if (ImGui::Button("Save as...", size)) {
    leave(desk);
    desk.ask(Question::kSaveAs);
    return;
  }
  ImGui::SameLine();
  if (ImGui::Button("Keep and quit", size)) desk.quit = true;
  ImGui::SameLine();
  if (ImGui::Button("Stay", size)) leave(desk);
}

bool Questions::find_kept(const fs::path& folder) {
  kept_ = kept_sessions(folder);
  return !kept_.empty();
}

void Questions::recover(Desk& desk) {
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted("Sessions that were never saved");
  ImGui::PopFont();
  ImGui::TextDisabled("Everything that was done in them is here, also after a crash.");
  ImGui::Spacing();
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const KeptSession& kept = kept_[i];
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s, %zu steps, %s", kept.scene.c_str(), kept.steps, kept.when.c_str());
    ImGui::SameLine(desk.theme.px(380.0F));
    const bool opened = ImGui::Button("Go on", {desk.theme.px(86.0F), 0.0F});
    if (opened) open_path(desk, kept.folder);
    ImGui::SameLine();
    const bool gone = ImGui::Button("Throw away", {desk.theme.px(100.0F), 0.0F});
    ImGui::PopID();
    std::error_code error;
    if (gone) fs::remove_all(kept.folder, error);
    if (gone) kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
    if (opened || kept_.empty()) return leave(desk);
    if (gone) break;
  }
  ImGui::Spacing();
  if (ImGui::Button("Not now", {desk.theme.px(86.0F), 0.0F})) leave(desk);
}

void Questions::draw(Desk& desk) {
  if (desk.question == Question::kNone) return;
  if (desk.question == Question::kQuit &&
      (!desk.has_shot() || !desk.now->history.unsaved || desk.now->history.undo_steps == 0)) {
    desk.quit = true;
    return;
  }
  if (!desk.question_asked) begin(desk);
  const ImVec2 center = ImGui::GetMainViewport()->GetCenter();
  ImGui::SetNextWindowPos(center, ImGuiCond_Always, {0.5F, 0.5F});
  const bool small = desk.question == Question::kQuit || desk.question == Question::kExport;
  ImGui::SetNextWindowSize({desk.theme.px(small ? 420.0F : 680.0F), 0.0F});
  if (!ImGui::BeginPopupModal("question", nullptr,
                              ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) {
    return;
  }
  if (desk.question == Question::kKeys) {
    keys(desk);
  } else if (desk.question == Question::kQuit) {
    quit(desk);
  } else if (desk.question == Question::kRecover) {
    recover(desk);
  } else if (desk.question == Question::kExport) {
    choose_export(desk);
  } else {
    files(desk);
  }
  if (desk.question == Question::kNone || !desk.question_asked) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace luminist
