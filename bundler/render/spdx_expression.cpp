// See spdx_expression.hpp.
#include "bundler/render/spdx_expression.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::array<std::string_view, 50> kIdentifiers{"0BSD",          "AFL-3.0",
                                                        "AGPL-3.0-only", "AGPL-3.0-or-later",
                                                        "Apache-1.1",    "Apache-2.0",
                                                        "Artistic-2.0",  "BlueOak-1.0.0",
                                                        "BSD-1-Clause",  "BSD-2-Clause",
                                                        "BSD-3-Clause",  "BSD-4-Clause",
                                                        "BSL-1.0",       "CC-BY-3.0",
                                                        "CC-BY-4.0",     "CC-BY-SA-4.0",
                                                        "CC-BY-NC-4.0",  "CC0-1.0",
                                                        "CDDL-1.0",      "curl",
                                                        "EPL-1.0",       "EPL-2.0",
                                                        "EUPL-1.2",      "FTL",
                                                        "GPL-2.0-only",  "GPL-2.0-or-later",
                                                        "GPL-3.0-only",  "GPL-3.0-or-later",
                                                        "HPND",          "ICU",
                                                        "ISC",           "LGPL-2.0-or-later",
                                                        "LGPL-2.1-only", "LGPL-2.1-or-later",
                                                        "LGPL-3.0-only", "LGPL-3.0-or-later",
                                                        "libpng-2.0",    "MIT",
                                                        "MIT-0",         "MIT-CMU",
                                                        "MPL-1.1",       "MPL-2.0",
                                                        "NCSA",          "OFL-1.1",
                                                        "OpenSSL",       "Python-2.0",
                                                        "PSF-2.0",       "Unicode-3.0",
                                                        "Unlicense",     "Zlib"};

constexpr std::array<std::string_view, 5> kExceptions{"Classpath-exception-2.0",
                                                      "GCC-exception-3.1", "LLVM-exception",
                                                      "OpenSSL-exception", "eCos-exception-2.0"};

/// License texts that people write, in lower case, and their SPDX identifiers.
constexpr std::array<std::pair<std::string_view, std::string_view>, 40> kOtherWords{{
    {"apache license 2.0", "Apache-2.0"},
    {"apache license, version 2.0", "Apache-2.0"},
    {"apache license version 2.0", "Apache-2.0"},
    {"apache 2.0", "Apache-2.0"},
    {"apache 2", "Apache-2.0"},
    {"apache2", "Apache-2.0"},
    {"apache2.0", "Apache-2.0"},
    {"apache-2", "Apache-2.0"},
    {"apache-2.0 license", "Apache-2.0"},
    {"apache 2.0 license", "Apache-2.0"},
    {"mit license", "MIT"},
    {"the mit license", "MIT"},
    {"bsd 2-clause", "BSD-2-Clause"},
    {"bsd-2", "BSD-2-Clause"},
    {"bsd 3-clause", "BSD-3-Clause"},
    {"bsd 3 clause", "BSD-3-Clause"},
    {"bsd-3", "BSD-3-Clause"},
    {"3-clause bsd", "BSD-3-Clause"},
    {"bsd-3-clause license", "BSD-3-Clause"},
    {"bsd license 2.0", "BSD-3-Clause"},
    {"boost software license", "BSL-1.0"},
    {"boost software license 1.0", "BSL-1.0"},
    {"gplv2", "GPL-2.0-only"},
    {"gpl-2.0", "GPL-2.0-only"},
    {"gplv3", "GPL-3.0-only"},
    {"gpl-3.0", "GPL-3.0-only"},
    {"gpl-3.0+", "GPL-3.0-or-later"},
    {"gpl-2.0+", "GPL-2.0-or-later"},
    {"gnu general public license v3.0", "GPL-3.0-only"},
    {"gnu gpl v3", "GPL-3.0-only"},
    {"lgplv2.1", "LGPL-2.1-only"},
    {"lgpl-2.1", "LGPL-2.1-only"},
    {"lgplv3", "LGPL-3.0-only"},
    {"lgpl-3.0", "LGPL-3.0-only"},
    {"gnu lesser general public license v3.0", "LGPL-3.0-only"},
    {"mpl 2.0", "MPL-2.0"},
    {"mozilla public license 2.0", "MPL-2.0"},
    {"isc license", "ISC"},
    {"cc0", "CC0-1.0"},
    {"psf-2.0 license", "PSF-2.0"},
}};

constexpr std::size_t kLongest = 1000;

template <std::size_t Count>
std::optional<std::string_view> known(const std::array<std::string_view, Count>& names,
                                      std::string_view word) {
  const std::string low = ascii_lower(word);
  for (const std::string_view name : names) {
    if (ascii_lower(name) == low) return name;
  }
  return std::nullopt;
}

/// `(`, `)` and words.
std::vector<std::string_view> tokens_of(std::string_view text) {
  std::vector<std::string_view> tokens;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ') {
      ++at;
    } else if (text[at] == '(' || text[at] == ')') {
      tokens.push_back(text.substr(at++, 1));
    } else {
      const std::size_t end = std::min(text.find_first_of(" ()", at), text.size());
      tokens.push_back(text.substr(at, end - at));
      at = end;
    }
  }
  return tokens;
}

/// One pass: `open` counts parentheses, and a license and an operator alternate.
std::optional<std::string> expression_of(const std::vector<std::string_view>& tokens) {
  std::string out;
  std::size_t open = 0;
  bool license_next = true;
  bool exception_next = false;
  for (const std::string_view token : tokens) {
    if (exception_next) {
      const auto exception = known(kExceptions, token);
      if (!exception) return std::nullopt;
      out.append(" WITH ").append(*exception);
      exception_next = false;
    } else if (license_next && token == "(") {
      ++open;
      out += '(';
    } else if (license_next) {
      const auto license = known(kIdentifiers, token);
      if (!license) return std::nullopt;
      out += *license;
      license_next = false;
    } else if (token == ")") {
      if (open == 0) return std::nullopt;
      --open;
      out += ')';
    } else if (const std::string word = ascii_lower(token); word == "with") {
      if (out.ends_with(')')) return std::nullopt;
      exception_next = true;
    } else if (word == "and" || word == "or") {
      out += word == "and" ? " AND " : " OR ";
      license_next = true;
    } else {
      return std::nullopt;
    }
  }
  if (out.empty() || open != 0 || license_next || exception_next) return std::nullopt;
  return out;
}

}  // namespace

std::optional<std::string> spdx_expression(std::string_view text) {
  const std::string_view words = trimmed(text);
  if (words.empty() || words.size() > kLongest) return std::nullopt;
  const std::string low = ascii_lower(words);
  for (const auto& [other, identifier] : kOtherWords) {
    if (other == low) return std::string(identifier);
  }
  return expression_of(tokens_of(words));
}

bool is_spdx_identifier(std::string_view text) {
  return known(kIdentifiers, text).has_value();
}

}  // namespace ros2wasm
