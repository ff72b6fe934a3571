#pragma once

/// From now on Ctrl-C (and a polite kill) asks for a clean stop; a second one ends the program at once.
void catch_interrupts();
/// True once a stop was asked for.
bool interrupted();

/// Exit code after Ctrl-C, as shells have it.
inline constexpr int interrupted_exit_code = 130;
