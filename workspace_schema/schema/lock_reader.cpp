// Reading of lock.hpp. All faults at once, each with its place.
#include <algorithm>
#include <functional>
#include <map>

#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"
#include "workspace_schema/conda/record_rules.hpp"
#include "workspace_schema/schema/lock.hpp"
#include "workspace_schema/schema/named_source.hpp"

namespace ros2wasm {
namespace {

bool is_hex(const std::string& text, std::size_t digits) {
  return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

class Reader {
 public:
  explicit Reader(const SourceText& source) : source_(source) {}

  Outcome<Lock> read() {
    auto document = parse_yaml(source_);
    if (!document) {
      for (Diagnostic& error : std::move(document).errors()) {
        error.code = "R2W0310";
        faults_.push_back(std::move(error));
      }
      return faults_;
    }
    for (Diagnostic& problem : document->problems) {
      problem.code = "R2W0310";
      faults_.push_back(std::move(problem));
    }
    Lock lock;
    if (document->root.kind != YamlKind::kMap) {
      return fault({0, 1}, "it is not a map of `schema`, `packages` and so on");
    }
    read_root(document->root, lock);
    if (!faults_.empty()) return faults_;
    return lock;
  }

 private:
  using Fields = std::map<std::string, std::function<void(const YamlNode&)>, std::less<>>;

  Diagnostic fault(TextRange range, const std::string& why) const {
    return Diagnostic{.code = "R2W0310",
                      .message = "`" + source_.file() + "` is not a lock that can be used: " + why,
                      .span = source_.span(range.offset, range.length),
                      .fix = {}};
  }
  void fail(const YamlNode& node, const std::string& why) {
    faults_.push_back(fault(node.range, why));
  }

  void text(const YamlNode& node, std::string& target) {
    if (node.kind == YamlKind::kScalar) {
      target = node.text;
    } else {
      fail(node, "a text is expected here");
    }
  }

  template <typename Number>
  void number(const YamlNode& node, Number& target) {
    const YamlValue value = node.kind == YamlKind::kScalar ? scalar_value(node) : YamlValue();
    const auto* integer = std::get_if<std::int64_t>(&value);
    if (integer != nullptr && *integer >= 0) {
      target = static_cast<Number>(*integer);
    } else {
      fail(node, "a number that is not negative is expected here");
    }
  }

  void texts(const YamlNode& node, std::vector<std::string>& target) {
    if (node.kind != YamlKind::kSequence) return fail(node, "a list is expected here");
    for (const YamlNode& item : node.items) text(item, target.emplace_back());
  }

  void hash(const YamlNode& node, std::string& target, std::size_t digits) {
    text(node, target);
    if (!is_hex(target, digits))
      fail(node, "a hash of " + std::to_string(digits) + " hexadecimal digits is expected");
  }

  void noarch(const YamlNode& node, NoarchKind& target) {
    std::string word;
    text(node, word);
    if (word != "generic" && word != "python")
      return fail(node, "`noarch` is `generic` or `python`");
    target = word == "python" ? NoarchKind::kPython : NoarchKind::kGeneric;
  }

  void read_fields(const YamlNode& map, const Fields& fields,
                   const std::vector<std::string_view>& required) {
    for (const YamlEntry& entry : map.entries) {
      const auto field = fields.find(entry.key);
      if (field == fields.end()) {
        faults_.push_back(fault(entry.key_range, "unknown key `" + entry.key + "`"));
      } else {
        field->second(entry.value);
      }
    }
    for (const std::string_view key : required) {
      const bool there = std::any_of(map.entries.begin(), map.entries.end(),
                                     [key](const YamlEntry& entry) { return entry.key == key; });
      if (!there) fail(map, "`" + std::string(key) + "` is missing");
    }
  }

  void read_root(const YamlNode& root, Lock& lock) {
    read_fields(
        root,
        {{"schema", [&](const YamlNode& node) { number(node, lock.schema); }},
         {"platform", [&](const YamlNode& node) { text(node, lock.platform); }},
         {"channels", [&](const YamlNode& node) { texts(node, lock.channels); }},
         {"specs", [&](const YamlNode& node) { texts(node, lock.specs); }},
         {"absent", [&](const YamlNode& node) { texts(node, lock.absent); }},
         {"built_here", [&](const YamlNode& node) { texts(node, lock.built_here); }},
         {"packages", [&](const YamlNode& node) { read_packages(node, lock.packages); }},
         {"sources", [&](const YamlNode& node) { read_sources(node, lock.sources); }},
         {"wheels", [&](const YamlNode& node) { read_wheels(node, lock.wheels); }},
         {"python_index", [&](const YamlNode& node) { text(node, lock.python_index); }},
         {"libraries", [&](const YamlNode& node) { read_libraries(node, lock.libraries); }}},
        {"schema", "platform", "packages"});
    std::sort(lock.absent.begin(), lock.absent.end());
    if (lock.schema != 1 && faults_.empty()) {
      fail(root,
           "it has schema " + std::to_string(lock.schema) + ", and this ros2wasm reads schema 1");
    }
  }

  void read_packages(const YamlNode& node, std::vector<PackageRecord>& packages) {
    if (node.kind != YamlKind::kSequence) return fail(node, "a list is expected here");
    for (const YamlNode& item : node.items) {
      if (item.kind != YamlKind::kMap) {
        fail(item, "a package is a map");
        continue;
      }
      packages.push_back(read_package(item));
    }
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < packages.size(); ++i) {
      if (++seen[packages[i].name] == 2)
        fail(node, "the package `" + packages[i].name + "` is there twice");
    }
  }

  void read_sources(const YamlNode& node, std::vector<LockedSource>& sources) {
    if (node.kind != YamlKind::kSequence) return fail(node, "a list is expected here");
    for (const YamlNode& item : node.items) {
      if (item.kind != YamlKind::kMap) {
        fail(item, "a source is a map");
        continue;
      }
      LockedSource& source = sources.emplace_back();
      read_fields(item,
                  {{"git", [&](const YamlNode& one) { text(one, source.git); }},
                   {"revision", [&](const YamlNode& one) { text(one, source.revision); }},
                   {"commit", [&](const YamlNode& one) { hash(one, source.commit, 40); }},
                   {"tree", [&](const YamlNode& one) { hash(one, source.tree, 40); }},
                   {"package", [&](const YamlNode& one) { text(one, source.package); }},
                   {"packages", [&](const YamlNode& one) { texts(one, source.packages); }},
                   {"archive", [&](const YamlNode& one) { text(one, source.archive); }},
                   {"size", [&](const YamlNode& one) { number(one, source.size); }},
                   {"model", [&](const YamlNode& one) { text(one, source.model); }},
                   {"sha256", [&](const YamlNode& one) { hash(one, source.sha256, 64); }}},
                  {});
      const bool is_whole = source.git.empty()
                                ? !source.archive.empty() && !source.sha256.empty() &&
                                      source.commit.empty() && source.tree.empty()
                                : source.archive.empty() && source.sha256.empty() &&
                                      !source.commit.empty() && !source.tree.empty();
      if (!is_whole)
        fail(item, "a source has `git`, `commit` and `tree`, or `archive` and `sha256`");
      // A lock may be a stranger's, and git takes some texts for options.
      if (!git_address_fault(source.git).empty() || !git_revision_fault(source.revision).empty())
        fail(item, "git cannot be given this address or revision");
      if (!source.archive.empty() && !file_place_fault(source.archive).empty())
        fail(item, "an archive has an address of the web or a relative path");
    }
  }

  void read_wheels(const YamlNode& node, std::vector<LockedWheel>& wheels) {
    if (node.kind != YamlKind::kSequence) return fail(node, "a list is expected here");
    for (const YamlNode& item : node.items) {
      if (item.kind != YamlKind::kMap) {
        fail(item, "a wheel is a map");
        continue;
      }
      LockedWheel& wheel = wheels.emplace_back();
      read_fields(item,
                  {{"name", [&](const YamlNode& one) { text(one, wheel.project); }},
                   {"version", [&](const YamlNode& one) { text(one, wheel.version); }},
                   {"file", [&](const YamlNode& one) { text(one, wheel.file); }},
                   {"url", [&](const YamlNode& one) { text(one, wheel.url); }},
                   {"sha256", [&](const YamlNode& one) { hash(one, wheel.sha256, 64); }},
                   {"size", [&](const YamlNode& one) { number(one, wheel.size); }}},
                  {"name", "version", "sha256"});
      if (wheel.file.empty() == wheel.url.empty()) fail(item, "a wheel has `file` or `url`");
    }
  }

  void read_libraries(const YamlNode& node, std::vector<LockedLibrary>& libraries) {
    if (node.kind != YamlKind::kSequence) return fail(node, "a list is expected here");
    for (const YamlNode& item : node.items) {
      if (item.kind != YamlKind::kMap) {
        fail(item, "a library is a map");
        continue;
      }
      LockedLibrary& library = libraries.emplace_back();
      read_fields(item,
                  {{"name", [&](const YamlNode& one) { text(one, library.project); }},
                   {"version", [&](const YamlNode& one) { text(one, library.version); }},
                   {"file", [&](const YamlNode& one) { text(one, library.file); }},
                   {"sha256", [&](const YamlNode& one) { hash(one, library.sha256, 64); }},
                   {"depends", [&](const YamlNode& one) { texts(one, library.depends); }}},
                  {"name", "version", "file", "sha256"});
      if (library.file.find('/') != std::string::npos || library.file.starts_with('.'))
        fail(item, "`file` of a library is the name of a file, without folders");
    }
  }

  PackageRecord read_package(const YamlNode& map) {
    PackageRecord record;
    read_fields(
        map,
        {{"name", [&](const YamlNode& node) { text(node, record.name); }},
         {"version", [&](const YamlNode& node) { text(node, record.version); }},
         {"build", [&](const YamlNode& node) { text(node, record.build); }},
         {"build_number", [&](const YamlNode& node) { number(node, record.build_number); }},
         {"subdir", [&](const YamlNode& node) { text(node, record.subdir); }},
         {"channel", [&](const YamlNode& node) { text(node, record.channel); }},
         {"file", [&](const YamlNode& node) { text(node, record.file_name); }},
         {"url", [&](const YamlNode& node) { text(node, record.url); }},
         {"sha256", [&](const YamlNode& node) { hash(node, record.sha256, 64); }},
         {"md5", [&](const YamlNode& node) { hash(node, record.md5, 32); }},
         {"size", [&](const YamlNode& node) { number(node, record.size); }},
         {"depends", [&](const YamlNode& node) { texts(node, record.depends); }},
         {"constrains", [&](const YamlNode& node) { texts(node, record.constrains); }},
         {"track_features", [&](const YamlNode& node) { texts(node, record.track_features); }},
         {"license", [&](const YamlNode& node) { text(node, record.license); }},
         {"timestamp_ms", [&](const YamlNode& node) { number(node, record.timestamp_ms); }},
         {"noarch", [&](const YamlNode& node) { noarch(node, record.noarch); }}},
        {"name", "version", "build", "subdir", "channel", "file", "url"});
    const std::string stem = distribution_name(record);
    if (record.file_name != stem + ".conda" && record.file_name != stem + ".tar.bz2") {
      fail(map, "the file `" + record.file_name + "` is not that of `" + stem + "`");
    } else if (!record.url.ends_with("/" + record.file_name)) {
      fail(map, "the url of `" + stem + "` does not end with its file");
    } else if (const auto bad = record_fault(record, Strictness::kReading)) {
      fail(map, *bad);
    }
    return record;
  }

  const SourceText& source_;
  Diagnostics faults_;
};

}  // namespace

Outcome<Lock> read_lock(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  return Reader(source).read();
}

}  // namespace ros2wasm
