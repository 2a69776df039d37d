#include "cli/command_line.h"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/studio_app.h"
#include "cli/verb.h"

namespace luminist {
namespace {

/// A file that is opened must not become stdout because somebody closed that.
void hold_standard_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(fd, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) < 0) ::_exit(static_cast<int>(ErrorKind::kUnwritable));
  }
}

struct DeclaredVerb {
  CLI::App* app;
  Verb run;
};

std::vector<DeclaredVerb> declare_verbs(CLI::App& app) {
  struct Entry {
    const char* name;
    const char* doc;
    Verb (*declare)(CLI::App&);
  };
  std::vector<DeclaredVerb> verbs;
  for (const Entry& entry : {Entry{"render", "Draws a shot", declare_render},
                             Entry{"paint", "Paints strokes on a shot's picture: target and importance", declare_paint},
                             Entry{"carry", "Carries strokes to another frame or camera", declare_carry},
                             Entry{"solve", "Finds the lights for what is painted", declare_solve},
                             Entry{"alternatives", "Finds different lights for the same paint", declare_alternatives},
                             Entry{"remove", "Removes a light; the others make up for it", declare_remove},
                             Entry{"diet", "Finds the fewest lights that keep the picture", declare_diet},
                             Entry{"replay", "Runs an action script, or a recorded project", declare_replay},
                             Entry{"golden", "Compares a style's golden pictures with new ones", declare_golden},
                             Entry{"prep", "Repairs meshes and says what was wrong with them", declare_prep},
                             Entry{"farm", "Writes a sequence as a job for a render farm", declare_farm},
                             Entry{"doc", "Prints the parameters of all lights and styles", declare_doc},
                             Entry{"info", "Prints what the machine and this build offer", declare_info}}) {
    CLI::App* sub = app.add_subcommand(entry.name, entry.doc);
    verbs.push_back({sub, entry.declare(*sub)});
  }
  return verbs;
}

/// Help goes to stdout with status 0; what cannot be understood is a usage error.
int answer_parse_error(const CLI::App& app, const CLI::ParseError& parse, Console& console) {
  if (parse.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    const bool version = dynamic_cast<const CLI::CallForVersion*>(&parse) != nullptr;
    console.result(version ? std::string("luminist ") + LUMINIST_VERSION : app.help());
    return console.finish() ? 0 : static_cast<int>(ErrorKind::kUnwritable);
  }
  std::string verb;
  for (const CLI::App* sub : app.get_subcommands()) verb = sub->get_name() + " ";
  std::string what = parse.what();
  for (char& c : what) c = c == '\n' ? ' ' : c;
  while (!what.empty() && (what.back() == ' ' || what.back() == '.')) what.pop_back();
  console.error({ErrorKind::kUsage, what, "", "", fmt::format("see luminist {}--help", verb)});
  return static_cast<int>(ErrorKind::kUsage);
}

int run_verb(const Verb& verb, Console& console, StopSignals& signals) {
  VerbContext context{console, signals, AssetRoots::standard()};
  auto status = verb(context);
  if (status) {
    if (auto finished = console.finish(); !finished) status = std::move(finished).error();
  }
  if (status) return *status;
  console.error(status.error());
  const bool stopped = status.error().kind == ErrorKind::kCancelled && signals.stopped() != 0;
  return stopped ? 128 + signals.stopped() : static_cast<int>(status.error().kind);
}

/// No verb opens the window; so does a file in its place.
bool wants_window(int argc, char** argv) {
  if (argc == 1) return true;
  return argc == 2 && argv[1][0] != '-' && std::filesystem::path(argv[1]).has_extension();
}

int open_window(int argc, char** argv, Console& console) {
  Result<int> status = 0;
  std::error_code error;
  if (argc > 1 && !std::filesystem::exists(argv[1], error)) {
    status = Error{ErrorKind::kMissing, "there is no such file", argv[1], "", "give a scene or a project"};
  } else {
    status = run_studio({AssetRoots::standard(), argc > 1 ? argv[1] : ""});
  }
  if (status) return *status;
  console.error(status.error());
  return static_cast<int>(status.error().kind);
}

int understand_and_run(int argc, char** argv, Console& console) {
  if (wants_window(argc, argv)) return open_window(argc, argv, console);
  StopSignals signals;
  CLI::App app("Luminist lights a 3D scene from paint: paint the light that you want to see, and it finds the lights.",
               "luminist");
  app.set_version_flag("--version", LUMINIST_VERSION);
  app.require_subcommand(1);
  app.footer(
      "luminist SCENE or luminist PROJECT.lum opens the studio window, luminist alone the demo scene.\n"
      "Each verb has examples: luminist solve --help");
  const std::vector<DeclaredVerb> verbs = declare_verbs(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer_parse_error(app, error, console);
  }
  for (const DeclaredVerb& verb : verbs) {
    if (verb.app->parsed()) return run_verb(verb.run, console, signals);
  }
  return static_cast<int>(ErrorKind::kUsage);  // require_subcommand() leaves nothing else
}

}  // namespace

int run_command_line(int argc, char** argv) {
  hold_standard_streams();
  std::signal(SIGPIPE, SIG_IGN);  // a reader that went away, and a file size limit, are errors of write()
  std::signal(SIGXFSZ, SIG_IGN);
  Console console;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--json") console.use_json(true);
  }
  try {
    return understand_and_run(argc, argv, console);
  } catch (const std::bad_alloc&) {
    console.error({ErrorKind::kLimit, "the memory is exhausted", "", "", "use a smaller picture or scene"});
  } catch (const std::length_error&) {
    console.error({ErrorKind::kLimit, "something is too large for the memory", "", "", "use a smaller picture"});
  }
  return static_cast<int>(ErrorKind::kLimit);
}

}  // namespace luminist
