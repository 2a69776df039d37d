#include "cli/task_words.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include "image_io/image_io.h"
#include "params/param_text.h"
#include "rig/light_links.h"
#include "studio/light_kinds.h"

namespace luminist {

void declare_paint_words(CLI::App& app, PaintWords& words) {
  CLI::Option* strokes = app.add_option("--paint", words.strokes, "Stroke file: what you want to see");
  app.add_option("--target", words.target, "Picture of what you want to see, .exr or .png")->excludes(strokes);
  app.add_option(
      "--importance", words.importance,
      "How much each pixel of --target counts, 0 not at all: importance.exr of a result, or a linear image (the "
      "importance.png of a result is a view, black where it counts)");
  app.add_option("--add-light", words.new_lights, "Adds so many lights where the paint wants them; locks the others")
      ->check(CLI::Range(0, 16));
  app.add_option(
      "--light-type", words.light.type,
      "Type of the lights that are added (default: cinematic); any, or any:point,sun: each is tried, and the "
      "one that makes the paint with the fewest degrees of freedom is added");
  app.add_option("--light-group", words.light.group, "Group of the lights that are added, as key (default: none)");
}

Result<void> check_paint_words(const PaintWords& words) {
  const auto usage = [](const char* what, const char* field, const char* hint) {
    return Error{ErrorKind::kUsage, what, "", field, hint};
  };
  if (words.strokes.empty() && words.target.empty()) {
    return usage("there is nothing to match", "--paint", "give strokes with --paint, or a picture with --target");
  }
  if (!words.importance.empty() && words.target.empty()) {
    return usage("an importance map goes with a picture", "--importance", "paint importance into the strokes instead");
  }
  return {};
}

Result<void> put_target(Session& session, const PaintWords& words, const AssetRoots& roots) {
  if (!words.strokes.empty()) {
    LUM_TRY(const std::string path, find_input(words.strokes, ".", roots));
    LUM_TRY(const StrokeFile strokes, load_strokes(path));
    return session.paint(strokes, path);
  }
  LUM_TRY(const std::string path, find_input(words.target, ".", roots));
  LUM_TRY(const Image color, read_image(path));
  std::optional<Image> importance;
  if (!words.importance.empty()) {
    LUM_TRY(const std::string importance_path, find_input(words.importance, ".", roots));
    LUM_TRY(importance, read_image(importance_path, Encoding::kLinear));
  }
  return session.set_target(color, importance);
}

/// The kinds that were tried, fewest degrees of freedom first.
void tell_kinds(const LightKinds& kinds, Console& console) {
  for (std::size_t i = 0; i < kinds.tried.size() && !console.json(); ++i) {
    const LightKind& kind = kinds.tried[i];
    console.result(fmt::format("{}: error {:.5f} with {} degrees of freedom{}", kind.type, kind.epsilon, kind.dofs,
                               i == kinds.chosen ? ", chosen" : ""));
  }
}

Result<void> add_new_lights(Session& session, const PaintWords& words, VerbContext& context) {
  if (words.new_lights > 0 && is_any_kind(words.light.type)) {
    if (words.new_lights > 1) {
      return Error{ErrorKind::kUsage, "one light at a time is added of any kind", "", "--add-light",
                   "write --add-light 1"};
    }
    const auto watch = [&](const SolveReport& report) {
      context.console.progress(report);
      return context.signals.stopped() == 0;
    };
    LUM_TRY(const LightKinds kinds, add_light_of_any_kind(session, words.light, {}, watch));
    tell_kinds(kinds, context.console);
    return {};
  }
  if (words.new_lights == 1) LUM_TRY_VOID(session.add_light(words.light));
  if (words.new_lights > 1) LUM_TRY_VOID(session.add_lights(words.new_lights, words.light));
  return {};
}

void declare_lock_words(CLI::App& app, LockWords& words) {
  app.add_option("--unlock", words.unlock, "Lets the solver turn what matches, as lights/key/color or lights/*/barn")
      ->allow_extra_args(false)
      ->type_name("PATTERN");
  app.add_option("--lock", words.lock, "Keeps what matches; later --lock and --unlock win over earlier ones")
      ->allow_extra_args(false)
      ->type_name("PATTERN");
}

void note_lock_order(const CLI::App& app, LockWords& words) {
  const CLI::Option* unlock = app.get_option("--unlock");
  const CLI::Option* lock = app.get_option("--lock");
  std::size_t unlocked = 0;
  std::size_t locked = 0;
  for (const CLI::Option* option : app.parse_order()) {
    if (option == unlock) words.ordered.emplace_back(words.unlock[unlocked++], false);
    if (option == lock) words.ordered.emplace_back(words.lock[locked++], true);
  }
}

Result<void> apply_locks(Session& session, const LockWords& words) {
  for (const auto& [pattern, locked] : words.ordered) LUM_TRY_VOID(session.set_locked(pattern, locked));
  return {};
}

/// Whether a name, or "group:NAME", is of a light that is there.
bool is_there(const LightRig& rig, const std::string& name) {
  constexpr std::string_view kGroup = "group:";
  return std::ranges::any_of(rig.lights, [&](const Light& light) {
    return name.starts_with(kGroup) ? light.group == name.substr(kGroup.size()) : light.name == name;
  });
}

/// Links lights that are there. returns the words about others.
Result<std::vector<std::string>> link_known(Session& session, const std::vector<std::string>& words) {
  std::vector<std::string> others;
  for (const std::string& each : words) {
    LUM_TRY(const LinkWords link, parse_link(each));
    if (!is_there(session.state().rig, link.light)) {
      others.push_back(each);
    } else {
      LUM_TRY_VOID(session.link_light(link.light, link.patterns));
    }
  }
  return others;
}

/// errors for lights that are not there, too.
Result<void> link_all(Session& session, const std::vector<std::string>& words) {
  for (const std::string& each : words) {
    LUM_TRY(const LinkWords link, parse_link(each));
    LUM_TRY_VOID(session.link_light(link.light, link.patterns));
  }
  return {};
}

/// Paint lies on a picture, so what is known of the lights that make it comes first.
Result<void> link_and_paint(Session& session, const PaintWords* paint, const std::vector<std::string>& links,
                            VerbContext& context) {
  LUM_TRY(const std::vector<std::string> later, link_known(session, links));
  if (paint != nullptr) {
    LUM_TRY_VOID(put_target(session, *paint, context.roots));
    if (paint->shares_lights) return {};
    LUM_TRY_VOID(add_new_lights(session, *paint, context));
  }
  return link_all(session, later);
}

Result<std::unique_ptr<Session>> open_task(Device& device, const Shot& shot, const PaintWords* paint,
                                           const ShotWords& words, const LockWords& locks, VerbContext& context,
                                           Diagnostics& diagnostics) {
  auto session = Session::open(device, context.roots, shot, ".", diagnostics);
  auto painted = session ? link_and_paint(**session, paint, words.link, context) : Result<void>();
  context.console.warn(diagnostics);
  if (!session) return session;
  LUM_TRY_VOID(std::move(painted));
  LUM_TRY_VOID((*session)->constrain(words.constrain));
  LUM_TRY_VOID(apply_locks(**session, locks));
  return session;
}

CLI::Option* declare_seconds(CLI::App& app, std::optional<double>& seconds, const std::string& doc) {
  CLI::Option* option = app.add_option("--seconds", seconds, doc);
  require_above_zero(*option);
  return option;
}

namespace {

void require_number(CLI::Option& option, const char* what, bool (*is_right)(double)) {
  option.check(CLI::Validator(
      [what, is_right](const std::string& text) {
        const auto number = parse_number(text);
        return number && is_right(*number) ? "" : fmt::format("\"{}\" is no number {}", text, what);
      },
      ""));
}

}  // namespace

void require_above_zero(CLI::Option& option) {
  require_number(option, "above 0", [](double x) { return x > 0.0; });
}
void require_from_zero(CLI::Option& option) {
  require_number(option, "from 0 on", [](double x) { return x >= 0.0; });
}

bool Deadline::go_on() const {
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  return signals_->stopped() == 0 && !(seconds_ && spent.count() >= *seconds_);
}

}  // namespace luminist
