#include "validation/html.h"

namespace nao::validation {
namespace {

constexpr const char* kStyle =
    "body{font:15px/1.45 sans-serif;max-width:960px;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}td,th{padding:2px 10px;text-align:left;"
    "border-bottom:1px solid #ddd}.stills{display:flex;flex-wrap:wrap;gap:6px}"
    "figure{margin:0}figcaption{font-size:12px;color:#666}svg{max-width:100%;height:auto}"
    ".verdict{font-size:19px;line-height:1.4}code{background:#f4f4f4;padding:1px 4px}";

std::string lineOf(const std::vector<std::string>& cells, const char* tag) {
  std::string out = "<tr>";
  for (const std::string& cell : cells) {
    out += std::string("<") + tag + ">" + escapeHtml(cell) + "</" + tag + ">";
  }
  return out + "</tr>\n";
}

}  // namespace

std::string escapeHtml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string toHtml(const TextTable& table) {
  std::string out = "<h2>" + escapeHtml(table.title) + "</h2>\n<table>" + lineOf(table.head, "th");
  for (const auto& line : table.lines) out += lineOf(line, "td");
  return out + "</table>\n";
}

std::string htmlPage(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
         escapeHtml(title) + "</title><style>" + kStyle + "</style></head><body>\n" + body +
         "</body></html>\n";
}

}  // namespace nao::validation
