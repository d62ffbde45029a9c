// See cached_configure.hpp.
#include "bundler/build/cached_configure.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "bundler/build/cached_work.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/replaced_text.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

// Lines: the key, the prefix, and the names of the files that name the prefix.
constexpr const char* kKept = "ros2wasm-configured";

constexpr std::array<std::string_view, 12> kCompiledSuffixes = {
    ".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".inl", ".ipp", ".tpp", ".txx"};

/// Commands with which CMake code can come to the contents of a C++ file, in lower case; those of
/// `file(` but for the one that lists names.
constexpr std::array<std::string_view, 4> kReaders = {"execute_process", "configure_file",
                                                      "try_compile", "try_run"};
constexpr std::string_view kFileCommand = "file(";
constexpr std::string_view kListing = "file(glob";

bool is_compiled(const fs::path& file) {
  const std::string suffix = file.extension().string();
  return std::find(kCompiledSuffixes.begin(), kCompiledSuffixes.end(), suffix) !=
         kCompiledSuffixes.end();
}

/// Made by compiler and linker, after the configure.
bool is_built(const fs::path& file) {
  const std::string suffix = file.extension().string();
  return suffix == ".o" || suffix == ".a" || suffix == ".wasm" || file.filename() == kKept;
}

bool is_cmake(const fs::path& file) {
  return file.filename() == "CMakeLists.txt" || file.extension() == ".cmake";
}

bool may_read_files(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (std::size_t at = 0; (at = text.find(kFileCommand, at)) != std::string::npos; ++at)
    if (text.compare(at, kListing.size(), kListing) != 0) return true;
  return std::any_of(kReaders.begin(), kReaders.end(), [&](std::string_view reader) {
    return text.find(reader) != std::string::npos;
  });
}

}  // namespace

Outcome<std::string> configure_key(const fs::path& work, const fs::path& sources,
                                   const std::vector<std::string>& arguments) {
  const auto files = seen_sources(work);
  if (!files) return files.errors();
  bool all_contents = false;
  for (const SeenSource& file : *files) {
    if (!is_cmake(file.path)) continue;
    auto text = read_file(sources / file.path, kMostOfList);
    if (!text) return text.errors();
    all_contents = all_contents || may_read_files(*std::move(text));
  }
  std::string text;
  for (const std::string& argument : arguments) text += argument + "\n";
  for (const SeenSource& file : *files) {
    const bool counts = all_contents || !is_compiled(file.path);
    text += file.path + (counts ? " " + file.sha256 : std::string()) + "\n";
  }
  return sha256_hex(text);
}

void forget_configure(const fs::path& work) {
  std::error_code ignored;
  fs::remove(work / kKept, ignored);
}

bool reuse_configure(const fs::path& work, const std::string& key, const fs::path& prefix) {
  const fs::path kept = work / kKept;
  const auto text = read_file(kept, kMostOfList);
  forget_configure(work);
  if (!text) return false;
  std::istringstream lines(*text);
  std::string known;
  std::string before;
  if (!std::getline(lines, known) || !std::getline(lines, before) || known != key) return false;
  std::string list = key + "\n" + prefix.string() + "\n";
  for (std::string name; std::getline(lines, name);) {
    list += name + "\n";
    if (before == prefix) continue;
    const auto file = read_file(work / name, kMostOfList);
    if (!file) return false;
    if (!write_file(work / name, with_replaced(*file, before, prefix.string()))) return false;
  }
  return static_cast<bool>(write_file(kept, list));
}

Outcome<Done> keep_configure(const fs::path& work, const std::string& key, const fs::path& prefix) {
  std::string list = key + "\n" + prefix.string() + "\n";
  std::error_code error;
  for (fs::recursive_directory_iterator it(work, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code gone;
    if (!it->is_regular_file(gone) || is_built(it->path())) continue;
    const auto text = read_file(it->path(), kMostOfList);
    if (!text) return text.errors();
    if (text->find(prefix.string()) != std::string::npos)
      list += it->path().lexically_relative(work).string() + "\n";
  }
  return write_file(work / kKept, list);
}

}  // namespace ros2wasm
