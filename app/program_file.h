#pragma once

#include <string>

namespace nao::app {

/// The file that a shell would start for this word, through PATH; empty: there is none.
std::string findProgram(const std::string& word);

/// Why a program's clocks can not be the world's; empty: they can. Programs that bring their own C
/// library, or use none, as Go's, never ask one that is put in its place.
std::string whyNoClock(const std::string& program);

}  // namespace nao::app
