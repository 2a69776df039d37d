// The actions of a script that look: another camera, another size, from anywhere.
#include "image_io/image_io.h"
#include "studio/script_runner.h"
#include "studio/shot_view.h"

namespace luminist {
namespace {

constexpr float kRadians = 0.01745329F;

Vec3 place(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

Result<void> ScriptRunner::reframe(const Action& action) {
  LUM_TRY(const auto camera, action.text("camera"));
  LUM_TRY(const auto size, action.size("size"));
  LUM_TRY(const auto frame, action.number("frame"));
  const Shot& shot = session_->shot();
  if (frame && size) return action.wrong("another size has no paint at any frame: give one of both", "size");
  if (frame) return session_->view().look_through({camera.value_or(shot.camera), *frame});
  return session_->view().reframe(camera.value_or(shot.camera), size ? size->first : shot.width,
                                  size ? size->second : shot.height);
}

Result<void> ScriptRunner::look(const Action& action) {
  LUM_TRY(const std::string name, action.needed_text("to"));
  LUM_TRY(const std::vector<double> from, action.numbers("from", 3));
  LUM_TRY(const std::vector<double> at, action.numbers("at", 3));
  LUM_TRY(const auto degrees, action.number("fov"));
  LUM_TRY(const auto size, action.size("size"));
  if (place(from) == place(at)) return action.wrong("it is where the camera stands", "at");
  if (degrees && !(*degrees > 0.0 && *degrees < 170.0)) return action.wrong("degrees from 0 to 170 are wanted", "fov");
  const Stage& stage = session_->stage();
  const float fov_y = degrees ? kRadians * static_cast<float>(*degrees) : stage.camera.fov_y;
  LUM_TRY(FreeView * view, session_->view().from_anywhere());
  LUM_TRY(const Image picture,
          view->picture(camera_at(place(from), place(at), fov_y), size ? size->first : session_->shot().width,
                        size ? size->second : session_->shot().height, session_->shown()));
  const std::filesystem::path path = output_ / name;
  LUM_TRY_VOID(make_folder(path.parent_path()));
  LUM_TRY_VOID(write_image(path.string(), picture));
  if (events_.written) events_.written(path);
  return {};
}

}  // namespace luminist
