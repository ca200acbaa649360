#pragma once

namespace slalom {

/// The scripts of the pages of runs: modules/io/report/*.js, put into the program at build time.
extern const char* const kRunScript;
extern const char* const kRunsScript;

}  // namespace slalom
