#pragma once

/// From now on a write to a pipe without reader, or beyond the largest file size, fails with an
/// error instead of ending the program.
void outlast_failing_writes();
/// From now on SIGINT (Ctrl-C), SIGTERM, SIGHUP (unless nohup ignores it) and a SIGPIPE from
/// another process request a clean stop. A second SIGINT or SIGTERM ends the program at once.
void catch_interrupts();
/// From now on only the parent process asks for a stop, by full::stop_signal; it gets the signals of the user.
void leave_interrupts_to_parent();
/// True after a stop was requested.
bool interrupted();

/// Exit code after Ctrl-C, by the convention of shells.
inline constexpr int interrupted_exit_code = 130;
