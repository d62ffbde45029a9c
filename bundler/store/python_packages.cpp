// See python_packages.hpp.
#include "bundler/store/python_packages.hpp"

#include <algorithm>

#include "bundler/archive/link_rules.hpp"
#include "bundler/io/files.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

bool is_python_package(const PackageRecord& record) {
  return record.noarch == NoarchKind::kPython;
}

Diagnostic no_python(const PackageRecord& record, std::string why) {
  return Diagnostic{.code = "R2W0242",
                    .message = "there is no Python that `" + distribution_name(record) +
                               "` could be installed for",
                    .why = {"it has `noarch: python`: where its files go depends on the package "
                            "`python`",
                            std::move(why)}};
}

/// "3.13" of "3.13.1"; empty when the version does not begin with two numbers.
std::string minor_version(const std::string& version) {
  constexpr const char* kDigits = "0123456789";
  const std::size_t dot = version.find_first_not_of(kDigits);
  if (dot == 0 || dot == std::string::npos || version[dot] != '.') return {};
  const std::size_t end = std::min(version.find_first_not_of(kDigits, dot + 1), version.size());
  return end == dot + 1 ? std::string() : version.substr(0, end);
}

}  // namespace

Outcome<std::string> site_packages_of(const std::vector<PackageRecord>& records,
                                      const std::vector<fs::path>& folders) {
  const auto needs = std::find_if(records.begin(), records.end(), is_python_package);
  if (needs == records.end()) return std::string();
  const auto python = std::find_if(records.begin(), records.end(), [](const PackageRecord& record) {
    return record.name == "python";
  });
  if (python == records.end()) {
    return no_python(*needs,
                     "no package of the lock is called `python`; under `dependencies:` of "
                     "workspace.yaml it can be asked for");
  }
  const std::string stem = distribution_name(*python);
  const auto text = read_file(
      folders[static_cast<std::size_t>(python - records.begin())] / "info/index.json", kMostOfList);
  if (!text) return text.errors();
  const auto json = parse_json(*text, "info/index.json of " + stem, "R2W0221");
  if (!json) return json.errors();
  if (const std::string own = json->text_of("python_site_packages_path"); !own.empty()) {
    auto inside = safe_member_path(own);
    if (inside) return std::move(*inside);
    return no_python(*needs, "`" + stem + "` wants its modules outside of the environment");
  }
  const std::string minor = minor_version(python->version);
  if (minor.empty()) return no_python(*needs, "`" + stem + "` has no version like 3.13");
  return "lib/python" + minor + "/site-packages";
}

std::string path_in_prefix(const std::string& path, std::string_view site_packages) {
  constexpr std::string_view kModules = "site-packages/";
  constexpr std::string_view kScripts = "python-scripts/";
  if (path.starts_with(kModules))
    return std::string(site_packages) + "/" + path.substr(kModules.size());
  if (path.starts_with(kScripts)) return "bin/" + path.substr(kScripts.size());
  return path;
}

}  // namespace ros2wasm
