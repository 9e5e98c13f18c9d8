// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/page.hpp"

#include "particles/errors.hpp"
#include "studies/numbers.hpp"
#include "studies/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>

namespace plenum::study {

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b)
      group = group << 8 | (b < n ? static_cast<unsigned char>(bytes[k + b]) : 0u);
    for (std::size_t d = 0; d < 4; ++d) text += d <= n ? digits[group >> (18 - 6 * d) & 63] : '=';
  }
  return text;
}

std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file) throw RunError(path.string() + ": cannot be read for the report");
  return bytes.str();
}

/// Columns whose cells are no numbers.
std::vector<bool> textColumns(const PageTable& table) {
  std::vector<bool> isText(table.columns.size(), false);
  for (const auto& row : table.rows)
    for (std::size_t c = 0; c < row.size(); ++c)
      if (!row[c].empty() && !numberIn(row[c])) isText[c] = true;
  return isText;
}

std::string htmlOf(const PageTable& table) {
  const std::vector<bool> isText = textColumns(table);
  const auto cell = [&](const char* tag, std::size_t c, const std::string& text) {
    return fmt::format("<{0}{1}>{2}</{0}>", tag, isText[c] ? " class=\"text\"" : "", escaped(text));
  };
  std::string html = "<div class=\"table\"><table>\n<thead><tr>";
  for (std::size_t c = 0; c < table.columns.size(); ++c) html += cell("th", c, table.columns[c]);
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) html += cell("td", c, row[c]);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string htmlOf(const PagePart& part) {
  std::string html;
  for (const std::string& paragraph : part.paragraphs)
    html += fmt::format("<p>{}</p>\n", escaped(paragraph));
  for (const std::string& svg : part.svgs) html += fmt::format("<div>{}</div>\n", svg);
  if (!part.table.rows.empty()) html += htmlOf(part.table);
  for (const PagePicture& picture : part.pictures)
    html += fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption>"
        "</figure>\n",
        escaped(picture.caption), base64(bytesOf(picture.png)));
  if (html.empty()) return "";
  return fmt::format("<h2>{}</h2>\n{}", escaped(part.heading), html);
}

}  // namespace

std::string htmlOf(const Page& page) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style>\n"
      "</head>\n<body>\n<h1>{0}</h1>\n",
      escaped(page.title), pageStyle);
  for (const PagePart& part : page.parts) html += htmlOf(part);
  return html + fmt::format("<script>{}</script>\n</body>\n</html>\n", pageScript);
}

}  // namespace plenum::study
