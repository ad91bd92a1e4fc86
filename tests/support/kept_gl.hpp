#pragma once

namespace edgeshade::test {

/// Loads what EGL loads for a display, Mesa and the LLVM that it draws with, and keeps it: to load
/// it again for each context takes longer than most tests draw. Where these libraries have other
/// names, only time is lost.
void keepGlLoaded();

} // namespace edgeshade::test
