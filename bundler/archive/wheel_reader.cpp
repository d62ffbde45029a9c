// See wheel_reader.hpp.
#include "bundler/archive/wheel_reader.hpp"

#include <algorithm>
#include <optional>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/side_module.hpp"
#include "bundler/archive/zip_files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = 256ULL << 20U;
constexpr std::size_t kMostFaults = 10;
constexpr std::string_view kHashKind = "sha256=";

using Files = std::map<std::string, ZipFile>;

std::string called(const WheelName& name) {
  return name.project + "-" + name.version + "-" + name.tags + ".whl";
}

Diagnostic unfit(const std::string& name, std::string why) {
  return Diagnostic{.code = "R2W0243",
                    .message = "the wheel `" + name + "` cannot be installed for a site",
                    .why = {std::move(why)}};
}

std::string url_base64(const std::string& hex) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  const auto nibble = [&](std::size_t i) {
    const char c = hex[i];
    return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10);
  };
  std::string out;
  unsigned value = 0;
  unsigned bits = 0;
  for (std::size_t i = 0; i < hex.size(); ++i) {
    value = (value << 4U) | nibble(i);
    for (bits += 4; bits >= 6; bits -= 6) out += kDigits[(value >> (bits - 6)) & 63U];
  }
  if (bits > 0) out += kDigits[(value << (6 - bits)) & 63U];
  return out;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

struct RecordRow {
  std::string path;
  std::string hash;
  std::string size;
};

/// `path,hash,size`, where a path with a comma stands in quotes.
std::optional<RecordRow> record_row(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      const bool doubled = quoted && i + 1 < line.size() && line[i + 1] == '"';
      if (doubled) cells.back() += line[i++];
      if (!doubled) quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  if (quoted || cells.size() != 3) return std::nullopt;
  return RecordRow{std::move(cells[0]), std::move(cells[1]), std::move(cells[2])};
}

/// The differences between RECORD and the files, as sentences.
std::vector<std::string> record_faults(const Files& files, const std::string& info) {
  const std::string own = info + "RECORD";
  std::vector<std::string> faults;
  std::map<std::string, RecordRow> rows;
  for (const std::string_view line : lines_of(files.at(own).bytes)) {
    if (line.empty()) continue;
    auto row = record_row(line);
    if (!row) {
      faults.emplace_back("RECORD has a line that is none");
      continue;
    }
    std::string path = row->path;
    rows.emplace(std::move(path), std::move(*row));
  }
  for (const auto& [path, found] : files) {
    // These can stand in no list of hashes, since they hold it.
    if (path == own || path == own + ".jws" || path == own + ".p7s") continue;
    const auto row = rows.find(path);
    if (row == rows.end()) {
      faults.push_back("`" + path + "` is not listed");
    } else if (!row->second.hash.starts_with(kHashKind)) {
      faults.push_back("`" + path + "` is listed without a sha256");
    } else if (row->second.hash.substr(kHashKind.size()) != url_base64(sha256_hex(found.bytes))) {
      faults.push_back("`" + path + "` has another sha256 than listed");
    } else if (!row->second.size.empty() &&
               row->second.size != std::to_string(found.bytes.size())) {
      faults.push_back("`" + path + "` has another size than listed");
    }
  }
  for (const auto& [path, row] : rows) {
    if (!files.contains(path)) faults.push_back("`" + path + "` is missing");
  }
  if (faults.size() > kMostFaults) {
    const std::size_t more = faults.size() - kMostFaults;
    faults.resize(kMostFaults);
    faults.push_back("and " + std::to_string(more) + " more");
  }
  return faults;
}

/// The values of a header, as in a mail: "Name: x", up to the first empty line.
std::vector<std::string> header(std::string_view text, std::string_view name) {
  std::vector<std::string> values;
  for (const std::string_view line : lines_of(text)) {
    if (line.empty()) break;
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || ascii_lower(std::string(line.substr(0, colon))) != name)
      continue;
    const std::size_t start = line.find_first_not_of(" \t", colon + 1);
    values.emplace_back(start == std::string_view::npos ? "" : line.substr(start));
  }
  return values;
}

std::string first_of(const std::vector<std::string>& values) {
  return values.empty() ? std::string() : values.front();
}

/// "demo-1.0.dist-info/" of the only folder of that kind.
std::optional<std::string> info_folder(const Files& files) {
  std::optional<std::string> found;
  constexpr std::string_view kInfo = ".dist-info/";
  for (const auto& [path, file] : files) {
    const std::size_t end = path.find('/') + 1;
    if (end == 0 || !std::string_view(path).substr(0, end).ends_with(kInfo)) continue;
    if (found && *found != path.substr(0, end)) return std::nullopt;
    found = path.substr(0, end);
  }
  return found;
}

/// Where a member goes below site-packages; nothing for what a site has no use for.
std::optional<std::string> installed_path(const std::string& path) {
  constexpr std::string_view kData = ".data/";
  const std::size_t first = path.find('/') + 1;
  std::string result = path;
  if (first != 0 && std::string_view(path).substr(0, first).ends_with(kData)) {
    const std::size_t second = path.find('/', first) + 1;
    const std::string scheme = second == 0 ? "" : path.substr(first, second - first);
    if (scheme != "purelib/" && scheme != "platlib/") return std::nullopt;
    result = path.substr(second);
  }
  if (result.ends_with(".pyc")) return std::nullopt;
  return result;
}

/// "libgeos.so", and "libgeos.so.3".
bool is_library_name(std::string_view name) {
  const std::size_t ending = name.rfind(".so");
  return ending != std::string_view::npos &&
         name.find_first_not_of(".0123456789", ending + 3) == std::string_view::npos;
}

bool is_compiled(const std::string& path) {
  return path.ends_with(".so") || path.ends_with(".pyd") || path.ends_with(".dylib");
}

/// Other files that are called .so (of Linux, among the data of tests) cannot be loaded, and stay.
std::optional<Diagnostic> add_side_module(const std::string& name, const std::string& place,
                                          const std::string& bytes, Wheel& wheel) {
  constexpr std::string_view kMagic("\0asm", 4);
  if (!is_compiled(place) || !bytes.starts_with(kMagic)) return std::nullopt;
  auto read = read_side_module(bytes);
  if (const auto* fault = std::get_if<SideModuleFault>(&read))
    return refused_side_module(name, place, fault->why);
  wheel.side_modules.emplace(place, std::move(std::get<SideModule>(read).needed));
  return std::nullopt;
}

}  // namespace

Diagnostic refused_side_module(const std::string& archive, const std::string& module,
                               const std::string& why) {
  return Diagnostic{.code = "R2W0245",
                    .message = "the compiled module `" + module + "` of `" + archive +
                               "` is not one that a site may load",
                    .why = {"it " + why}};
}

Outcome<SharedLibraries> read_shared_libraries(const fs::path& file, const std::string& name,
                                               ExtractLimits limits) {
  limits.total_bytes = std::min(limits.total_bytes, kMostBytes);
  auto read = read_zip_files(file, name, limits);
  if (!read) return std::move(read).errors();
  SharedLibraries libraries;
  for (auto& [path, found] : *read) {
    std::string base = path.substr(path.rfind('/') + 1);
    if (!is_library_name(base)) continue;
    auto module = read_side_module(found.bytes);
    if (const auto* fault = std::get_if<SideModuleFault>(&module))
      return refused_side_module(name, path, fault->why);
    if (libraries.files.contains(base))
      return refused_archive("R2W0224", name, {"two of its members are called `" + base + "`"});
    libraries.needed.emplace(base, std::move(std::get<SideModule>(module).needed));
    libraries.files.emplace(std::move(base), std::move(found.bytes));
  }
  if (libraries.files.empty()) return damaged_archive(name, "it has no library");
  return libraries;
}

Outcome<Wheel> read_wheel(const fs::path& file, const WheelName& wanted, ExtractLimits limits) {
  const std::string name = called(wanted);
  limits.total_bytes = std::min(limits.total_bytes, kMostBytes);
  auto read = read_zip_files(file, name, limits);
  if (!read) return std::move(read).errors();
  Files files = std::move(*read);
  const auto info = info_folder(files);
  if (!info) return damaged_archive(name, "it has no .dist-info folder, or several");
  for (const char* needed : {"METADATA", "RECORD", "WHEEL"}) {
    if (!files.contains(*info + needed))
      return damaged_archive(name, "it has no " + *info + needed);
  }
  if (auto faults = record_faults(files, *info); !faults.empty()) {
    faults.insert(faults.begin(), "its files are not those that its RECORD lists");
    return refused_archive("R2W0226", name, std::move(faults));
  }
  const std::string& metadata = files.at(*info + "METADATA").bytes;
  Wheel wheel{.project = first_of(header(metadata, "name")),
              .version = first_of(header(metadata, "version")),
              .requirements = header(metadata, "requires-dist"),
              .python = first_of(header(metadata, "requires-python")),
              .files = {}};
  if (normal_project_name(wheel.project) != normal_project_name(wanted.project))
    return unfit(name, "its METADATA is that of `" + wheel.project + "`");
  if (normal_project_name(wheel.version) != normal_project_name(wanted.version))
    return unfit(name, "its METADATA is that of version " + wheel.version);
  if (!first_of(header(files.at(*info + "WHEEL").bytes, "wheel-version")).starts_with("1."))
    return unfit(name, "its form is newer than version 1");
  for (auto& [path, found] : files) {
    auto place = installed_path(path);
    if (!place) continue;
    if (is_compiled(*place) && !wanted.is_for_site_abi())
      return unfit(name, "it has a compiled module, `" + *place + "`, whatever its name says");
    if (auto fault = add_side_module(name, *place, found.bytes, wheel)) return *std::move(fault);
    if (!wheel.files.emplace(*place, std::move(found.bytes)).second)
      return refused_archive("R2W0224", name, {"two of its members go to `" + *place + "`"});
  }
  return wheel;
}

}  // namespace ros2wasm
