/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** Lets SIGINT, SIGTERM and SIGHUP ask the program to stop in place of ending it. One that comes
 * two seconds later or more ends it at once. SIGHUP stays ignored where it is, as under nohup. */
void catchStopSignals();

/** The signal that asked the program to stop; 0 where none did. Work that takes long looks at it
 * after each part of it, and then saves what was done. */
int stopSignal();

inline bool isToStop() { return stopSignal() != 0; }

/** The name of a signal that catchStopSignals() catches, such as "SIGINT". */
const char* nameOfSignal(int signal);
}  // namespace psmks
