#pragma once

#include <string>
#include <vector>

#include "validation/report.h"

namespace nao::validation {

/// Pieces of pages that need no other file.

/// Text with what HTML would take for its own replaced.
std::string escapeHtml(const std::string& text);

/// A heading and a table.
std::string toHtml(const TextTable& table);

/// All of a page, its look included. `body` is HTML, `title` text.
std::string htmlPage(const std::string& title, const std::string& body);

}  // namespace nao::validation
