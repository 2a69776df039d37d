#pragma once
// cli/command_line.h -- the program `luminist`, from its words to its exit status.

namespace luminist {

/// Exit status: 0; 1 where a comparison differs or a goal asked for was not reached; else the ErrorKind; 128 + the
/// signal that stopped it. One line on stderr says what went wrong. thread the main one, before any other is started.
int run_command_line(int argc, char** argv);

}  // namespace luminist
