#pragma once

/// From now on a write to a pipe that nobody reads, or beyond the largest size that a file may have, fails with an
/// error instead of ending the program.
void outlast_failing_writes();
/// From now on Ctrl-C, a polite kill, a terminal that closes (unless nohup wants it ignored) and a broken pipe that
/// another process tells of ask for a clean stop; a second Ctrl-C or polite kill ends the program at once.
void catch_interrupts();
/// True once a stop was asked for.
bool interrupted();

/// Exit code after Ctrl-C, as shells have it.
inline constexpr int interrupted_exit_code = 130;
