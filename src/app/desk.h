#pragma once
// app/desk.h -- what the parts of the window share: the session as it was last seen, and how the lighter looks at it.
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/brush_box.h"
#include "app/canvas_view.h"
#include "app/channels.h"
#include "app/key_map.h"
#include "app/theme.h"
#include "studio/studio_thread.h"

namespace luminist {

/// A message with the moment when it came, in seconds of the window's clock.
struct ToldMessage {
  StudioMessage message;
  double time = 0.0;
};

/// Which question is put over the window.
enum class Question { kNone, kOpen, kSaveAs, kExport, kExportFolder, kImage, kKeys, kQuit, kRecover };

/// What a drag on the picture says, in place of a stroke.
enum class DragGoal { kNone, kHighlight, kShadow };

struct Desk {
  StudioThread* studio = nullptr;
  AssetRoots roots{std::vector<std::filesystem::path>{}};
  Theme theme;
  std::shared_ptr<const StudioSnapshot> now;  ///< never null
  StudioThread::Activity activity;
  double time = 0.0;  ///< seconds of the window's clock

  BrushBox box;
  CanvasView view;
  DisplayOptions display;
  Channel channel = Channel::kLight;
  bool wipe = false;  ///< paint on the left of a line, light on the right
  float wipe_at = 0.5F;
  bool wipe_kept = false;             ///< the kept picture on the left
  std::shared_ptr<const Image> kept;  ///< a picture to compare with; null: none
  bool orbit = false;                 ///< the shot from anywhere, in place of the canvas
  bool shape_handles = true;          ///< a light that is selected shows its barn and cutoffs
  bool handles_aside = false;         ///< the hand paints: handles on the picture do not stand in its way
  bool software = false;              ///< the processor draws the window, too
  std::uint32_t pointed_stroke = 0;   ///< the canvas marks where it lies; 0: none
  std::uint32_t selected_stroke = 0;  ///< that the edit tool changes; 0: none
  std::string pen;                    ///< whether there is one, as a line
  bool pick_clip = false;             ///< the next click names the object that strokes stay on
  bool pick_material = false;         ///< the next click names the material whose parameters are shown
  DragGoal goal = DragGoal::kNone;    ///< drags move a highlight, or the edge of a shadow
  std::string linking;                ///< a light whose objects clicks on the picture choose; "": none
  bool space_down = false;
  bool hand_down = false;  ///< a stroke is under way

  std::string material;  ///< whose parameters are shown
  std::string selected;  ///< light; "" for none, "ambient", "style"
  std::set<std::string> solo;
  int key_map = 0;
  bool show_panels = true;
  std::optional<bool> show_shots;  ///< the frames below the picture; empty: where the shot has some
  Question question = Question::kNone;
  bool question_asked = false;  ///< its popup is open
  bool quit = false;
  std::deque<ToldMessage> messages;  ///< the last ones

  /// The stroke that is selected, or null.
  [[nodiscard]] const KeptStroke* edited_stroke() const;
  [[nodiscard]] bool has_shot() const { return now->facts && now->picture && now->painted && now->shown; }
  [[nodiscard]] const KeyMap& keys() const { return key_maps()[static_cast<std::size_t>(key_map)]; }
  /// "Undo (Ctrl+Z)"
  [[nodiscard]] std::string with_key(const std::string& text, Deed deed) const;
  void ask(Question wanted) { question = wanted, question_asked = false; }
  void tell(StudioMessage::Kind kind, std::string text);
  /// What was told concerns what was done before: the list keeps it, the line below the picture does not.
  void hush();
  /// Another snapshot. A stroke that is selected is one of its camera and frame.
  void see(std::shared_ptr<const StudioSnapshot> latest);
};

/// Does what a key, a menu or a button asks for. digit is that of Deed::kOpacity.
void perform(Desk& desk, Deed deed, int digit = 0);

/// A new light that waits for paint; what a solve proposes is accepted first. only_first: unless there is a light.
void add_light(Desk& desk, bool only_first = false);
void save(Desk& desk);
/// The stroke that is selected goes.
void delete_stroke(Desk& desk);

}  // namespace luminist
