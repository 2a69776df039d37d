#pragma once
// app/shots_panel.h -- the shot over time, below the picture: frames, keys, paint, and one rig for several frames and
// cameras.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/desk.h"
#include "app/picture_texture.h"
#include "app/timeline.h"

namespace luminist {

/// Whether the panel is on the window: as the lighter said, or where a shot has something to do with time.
bool shots_shown(const Desk& desk);

class ShotsPanel {
 public:
  /// Height of the panel, pixels.
  [[nodiscard]] static float height(const Theme& theme) { return theme.px(216.0F); }
  void draw(Desk& desk);
  /// Small pictures are made for a panel that is seen only.
  void hide(Desk& desk);

 private:
  void toolbar(Desk& desk, const FrameFacts& facts);
  [[nodiscard]] bool together_shown(const Desk& desk, const FrameFacts& facts) const;
  void strip(Desk& desk, const FrameFacts& facts);
  void refresh_strip(const Desk& desk, const FrameFacts& facts);
  void want(Desk& desk, int pictures);
  void timeline(Desk& desk, const FrameFacts& facts);
  void ruler(Desk& desk, const FrameFacts& facts, const TimeScale& scale, float height);
  static void clear_menu(Desk& desk, const Vantage& at);  ///< of the item before, by a right click
  void paint_row(Desk& desk, const FrameFacts& facts, const TimeScale& scale);
  void key_row(Desk& desk, const FrameFacts& facts, const TimeScale& scale, const KeyRow& row);
  void key_marks(Desk& desk, const KeyRow& row, const TimeScale& scale, float middle);
  void key_menu(Desk& desk, const KeyRow& row);
  void new_key(Desk& desk);
  void together(Desk& desk, const FrameFacts& facts);
  void choice_row(Desk& desk, const FrameFacts& facts, const PaintedFrame& painted);

  std::optional<bool> together_;  ///< the tab, as the lighter chose; else what the shot has
  int every_ = 4;                 ///< frames between pictures of the strip
  int wanted_pictures_ = 0;       ///< that was asked for
  int wanted_every_ = 0;
  KeyInterpolation interpolation_ = KeyInterpolation::kSmooth;  ///< of new keys
  std::optional<double> head_;                                  ///< frame under the hand that drags through time
  std::string held_row_;                                        ///< pattern of the key under the hand
  double held_from_ = 0.0;
  double held_to_ = 0.0;
  double menu_frame_ = 0.0;  ///< of the key whose menu is open
  struct Choice {
    bool on = true;
    float weight = 1.0F;
  };
  std::map<Vantage, Choice> choices_;
  bool judge_ = true;
  std::shared_ptr<const FrameFacts> textured_;
  DisplayOptions display_;
  std::vector<std::unique_ptr<PictureTexture>> textures_;
};

}  // namespace luminist
