// See interposition.hpp.
#include "bundler/build/interposition.hpp"

#include <set>

#include "bundler/build/wasm_object.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// A library may stand on a line twice, by two of its names.
fs::path real_path(const std::string& argument) {
  std::error_code error;
  return fs::weakly_canonical(argument, error);
}

}  // namespace

bool has_duplicates(std::string_view printed) {
  return printed.find(": duplicate symbol: ") != printed.npos;
}

Outcome<LinkLine> with_interposition(const LinkLine& line, const fs::path& folder,
                                     std::map<std::string, std::string>& copies) {
  struct Library {
    std::string bytes;
    std::vector<ObjectSymbol> defined;
  };
  std::vector<std::pair<fs::path, Library>> shared;  // in the order of the line
  std::set<fs::path> seen;
  std::set<std::string> defined;  // before the library that is looked at; first by the program
  for (const std::string& argument : line.arguments) {
    const bool is_archive = argument.ends_with(".a");
    if (!is_archive && !argument.ends_with(".o") && !argument.ends_with(".obj")) continue;
    if (argument.starts_with('-') || !seen.insert(real_path(argument)).second) continue;
    auto bytes = read_file(argument, kMostOfData);
    if (!bytes) continue;  // the linker says so
    auto symbols = is_archive ? archive_definitions(*bytes) : strong_definitions(*bytes);
    if (!symbols) continue;
    if (is_archive && is_natively_shared(*bytes)) {
      shared.emplace_back(real_path(argument), Library{std::move(*bytes), std::move(*symbols)});
    } else {
      for (ObjectSymbol& symbol : *symbols) defined.insert(std::move(symbol.name));
    }
  }
  std::map<fs::path, std::string> replaced;  // original -> copy
  for (auto& [path, library] : shared) {
    bool is_changed = false;
    std::multiset<std::string> own;
    for (const ObjectSymbol& symbol : library.defined) own.insert(symbol.name);
    for (const ObjectSymbol& symbol : library.defined) {
      if (symbol.is_hidden || !defined.contains(symbol.name) || own.count(symbol.name) > 1)
        continue;
      make_weak(library.bytes, symbol);
      is_changed = true;
    }
    for (const ObjectSymbol& symbol : library.defined)
      if (!symbol.is_hidden) defined.insert(symbol.name);
    if (!is_changed) continue;
    const fs::path copy = folder / std::to_string(replaced.size()) / path.filename();
    if (auto written = write_file(copy, library.bytes); !written)
      return std::move(written).errors();
    replaced[path] = copy.string();
    copies[copy.string()] = path.string();
  }
  LinkLine result = line;
  for (std::string& argument : result.arguments)
    if (const auto found = replaced.find(real_path(argument)); found != replaced.end())
      argument = found->second;
  return result;
}

}  // namespace ros2wasm
