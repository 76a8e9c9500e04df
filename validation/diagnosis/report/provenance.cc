#include "validation/diagnosis/report/provenance.h"

#include "validation/html.h"

namespace nao::validation {
namespace {

std::string code(const std::string& text) { return "<code>" + escapeHtml(text) + "</code>"; }

}  // namespace

std::string originInHtml(const Provenance& provenance) {
  return "Set " + code(provenance.set) + ", model " + code(provenance.model) + ", level " +
         escapeHtml(provenance.level);
}

std::string commandInHtml(const Provenance& provenance) {
  return "<p>To repeat it:</p>\n<p>" + code(provenance.command) +
         "</p>\n<p>with the same files. SHA-256 of the set's folder: " +
         code(provenance.set_sha256) + ", of the model's: " + code(provenance.model_sha256) +
         ".</p>\n";
}

}  // namespace nao::validation
