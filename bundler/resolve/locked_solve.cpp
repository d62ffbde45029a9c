// See locked_solve.hpp.
#include "bundler/resolve/locked_solve.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "bundler/io/files.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/conda/match_spec.hpp"

namespace ros2wasm {
namespace {

Diagnostic lock_does_not_fit(const std::filesystem::path& file, std::vector<std::string> why) {
  return Diagnostic{.code = "R2W0320",
                    .message = "with --locked nothing may change, but " + file.filename().string() +
                               " does not fit the workspace",
                    .why = std::move(why),
                    .fix = {"run `ros2wasm pack` once without --locked and keep the new lock"}};
}

/// Records of the lock that are still in the index, exactly as they were.
std::vector<PackageRecord> still_there(const std::vector<PackageRecord>& locked,
                                       const RepoIndex& index) {
  std::set<std::pair<std::string_view, std::string_view>> there;  // url, sha256
  for (const PackageRecord& record : index.records) there.emplace(record.url, record.sha256);
  std::vector<PackageRecord> result;
  for (const PackageRecord& one : locked) {
    if (there.contains({one.url, one.sha256})) result.push_back(one);
  }
  return result;
}

bool by_name(const PackageRecord& a, const PackageRecord& b) {
  return a.name < b.name;
}

/// The packages that would differ; both lists are sorted by name. A request or channels in other
/// words are not a change.
std::vector<std::string> changes_of(const std::vector<PackageRecord>& locked,
                                    const std::vector<PackageRecord>& chosen) {
  std::vector<std::string> changes;
  const auto of_name = [](const std::vector<PackageRecord>& records, const PackageRecord& one) {
    const auto found = std::lower_bound(records.begin(), records.end(), one, by_name);
    return found != records.end() && found->name == one.name ? &*found : nullptr;
  };
  for (const PackageRecord& record : chosen) {
    const PackageRecord* before = of_name(locked, record);
    const std::string name = distribution_name(record);
    if (before == nullptr) {
      changes.push_back("`" + name + "` would be new");
    } else if (distribution_name(*before) != name) {
      changes.push_back("`" + name + "` would take the place of `" + distribution_name(*before) +
                        "`");
    } else if (*before != record) {
      changes.push_back("the channel has another `" + name +
                        "` by now, or says other things of it");
    }
  }
  for (const PackageRecord& record : locked) {
    if (of_name(chosen, record) == nullptr)
      changes.push_back("nothing asks for `" + distribution_name(record) + "` any more");
  }
  return changes;
}

/// As sentences.
std::vector<std::string> changed_wheels(const std::vector<LockedWheel>& locked,
                                        const std::vector<LockedWheel>& wanted) {
  std::vector<std::string> changes;
  const auto of_project = [](const std::vector<LockedWheel>& wheels, const LockedWheel& one) {
    const auto found = std::find_if(wheels.begin(), wheels.end(), [&](const LockedWheel& other) {
      return other.project == one.project;
    });
    return found == wheels.end() ? nullptr : &*found;
  };
  for (const LockedWheel& wheel : wanted) {
    const LockedWheel* before = of_project(locked, wheel);
    if (before == nullptr) {
      changes.push_back("the wheel of `" + wheel.project + "` would be new");
    } else if (*before != wheel) {
      changes.push_back("the wheel of `" + wheel.project + "` is another one: it was " +
                        before->version + " with sha256 " + before->sha256);
    }
  }
  for (const LockedWheel& wheel : locked) {
    if (of_project(wanted, wheel) == nullptr)
      changes.push_back("the manifest names no wheel of `" + wheel.project + "` any more");
  }
  return changes;
}

std::vector<std::string> changed_libraries(const std::vector<LockedLibrary>& locked,
                                           const std::vector<LockedLibrary>& wanted) {
  std::vector<std::string> changes;
  const auto of_project = [](const std::vector<LockedLibrary>& libraries,
                             const LockedLibrary& one) {
    const auto found =
        std::find_if(libraries.begin(), libraries.end(),
                     [&](const LockedLibrary& other) { return other.project == one.project; });
    return found == libraries.end() ? nullptr : &*found;
  };
  for (const LockedLibrary& one : wanted) {
    const LockedLibrary* before = of_project(locked, one);
    if (before == nullptr) {
      changes.push_back("the Python library `" + one.project + "` would be new");
    } else if (*before != one) {
      changes.push_back("the Python library `" + one.project + "` is another one: it was " +
                        before->version + " with sha256 " + before->sha256);
    }
  }
  for (const LockedLibrary& one : locked) {
    if (of_project(wanted, one) == nullptr)
      changes.push_back("the Python library `" + one.project + "` is not asked for any more");
  }
  return changes;
}

std::vector<std::string> changed_sources(const std::vector<LockedSource>& locked,
                                         const std::vector<LockedSource>& wanted) {
  std::vector<std::string> changes;
  // Which packages are taken of a source is not a change of it.
  const auto has = [](const std::vector<LockedSource>& sources, LockedSource one) {
    return std::any_of(sources.begin(), sources.end(), [&one](const LockedSource& other) {
      one.packages = other.packages;
      return one == other;
    });
  };
  for (const LockedSource& one : wanted) {
    if (has(locked, one)) continue;
    changes.push_back("the source `" + (one.git.empty() ? one.archive : one.git) +
                      "` would be new, or is another one");
  }
  for (const LockedSource& one : locked) {
    if (!has(wanted, one))
      changes.push_back("the source `" + (one.git.empty() ? one.archive : one.git) +
                        "` is not asked for as it is in the lock");
  }
  return changes;
}

/// Those that one of the packages names, as the lock has them.
std::vector<std::string> needed_here(const std::vector<PackageRecord>& packages,
                                     const std::vector<PackageRecord>& built_here) {
  std::set<std::string> needed;
  for (const PackageRecord& record : packages) {
    for (const std::string& text : record.depends) {
      const auto spec = MatchSpec::parse(text);
      if (!spec) continue;
      for (const PackageRecord& one : built_here)
        if (spec->exact_name() == one.name) needed.insert(one.name + " " + one.version);
    }
  }
  return {needed.begin(), needed.end()};
}

bool is_among(const std::string& name, const std::vector<PackageRecord>& packages) {
  return std::any_of(packages.begin(), packages.end(),
                     [&name](const PackageRecord& record) { return record.name == name; });
}

}  // namespace

Diagnostic not_in_lock(const std::string& name, const std::vector<PackageRecord>& packages) {
  Diagnostic made{.code = "R2W0331", .message = "the lock has no package `" + name + "`"};
  std::vector<std::string> names;
  for (const PackageRecord& record : packages) names.push_back(record.name);
  if (const auto similar = nearest(name, names)) made.why.push_back("it has `" + *similar + "`");
  return made;
}

Diagnostics other_wheels(const std::vector<LockedWheel>& locked,
                         const std::vector<LockedWheel>& wanted) {
  Diagnostics faults;
  for (std::string& one : changed_wheels(locked, wanted))
    faults.push_back({.code = "R2W0311", .message = std::move(one)});
  return faults;
}

Diagnostics other_libraries(const std::vector<LockedLibrary>& locked,
                            const std::vector<LockedLibrary>& wanted) {
  Diagnostics faults;
  for (std::string& one : changed_libraries(locked, wanted))
    faults.push_back({.code = "R2W0311", .message = std::move(one)});
  return faults;
}

Outcome<Lock> read_lock_file(const std::filesystem::path& file) {
  if (is_absent(file)) {
    return Diagnostic{.code = "R2W0330",
                      .message = "there is no `" + file.string() + "`",
                      .why = {"`ros2wasm lock` and `ros2wasm pack` write it"},
                      .fix = {"ros2wasm lock"}};
  }
  const auto text = read_file(file, kMostOfList);
  if (!text) return text.errors();
  return read_lock(*text, file.string());
}

Outcome<LockedSolution> solve_with_lock(const std::vector<RequestedSpec>& specs,
                                        const LockRest& rest, const RepoIndex& index,
                                        const std::filesystem::path& lock_file,
                                        ChannelPriority priority, bool must_fit,
                                        const LockUpdate& update,
                                        const Cancellation& cancellation) {
  std::string old_text;
  std::vector<PackageRecord> locked;
  std::vector<LockedWheel> old_wheels;
  std::vector<LockedLibrary> old_libraries;
  std::vector<LockedSource> old_sources;
  std::vector<std::string> strangers;  // to choose anew, but not in the lock
  if (!is_absent(lock_file)) {
    auto text = read_file(lock_file, kMostOfList);
    if (!text) return std::move(text).errors();
    old_text = std::move(text).value();
    auto lock = read_lock(old_text, lock_file.filename().string());
    if (!lock) return std::move(lock).errors();
    locked = std::move(lock->packages);
    old_wheels = std::move(lock->wheels);
    old_libraries = std::move(lock->libraries);
    old_sources = std::move(lock->sources);
    std::copy_if(
        update.names.begin(), update.names.end(), std::back_inserter(strangers),
        [&locked](const std::string& name) { return !name.empty() && !is_among(name, locked); });
    std::erase_if(locked, [&update](const PackageRecord& record) {
      return update.everything ||
             std::find(update.names.begin(), update.names.end(), record.name) != update.names.end();
    });
  } else if (must_fit) {
    return lock_does_not_fit(lock_file, {"there is no " + lock_file.string()});
  }
  std::sort(locked.begin(), locked.end(), by_name);
  if (must_fit) {
    const Diagnostics faults = check_solution(specs, locked, index.built_here);
    if (!faults.empty()) {
      std::vector<std::string> why;
      for (const Diagnostic& fault : faults) why.push_back(fault.message);
      return lock_does_not_fit(lock_file, std::move(why));
    }
  }

  const ResolveRequest request{.specs = specs,
                               .locked = must_fit ? locked : still_there(locked, index),
                               .priority = priority};
  auto resolution = solve(request, index, {.cancellation = cancellation});
  if (!resolution) return std::move(resolution).errors();
  Diagnostics unknown;
  for (const std::string& name : strangers) {
    if (!is_among(name, resolution->packages))
      unknown.push_back(not_in_lock(name, resolution->packages));
  }
  if (!unknown.empty()) return unknown;
  Lock lock{.channels = index.channels,
            .absent = rest.absent,
            .built_here = needed_here(resolution->packages, index.built_here),
            .packages = resolution->packages,
            .sources = rest.sources,
            .wheels = rest.wheels,
            .python_index = rest.python_index,
            .libraries = rest.libraries};
  for (const RequestedSpec& spec : specs) lock.specs.push_back(spec.text);
  std::sort(lock.packages.begin(), lock.packages.end(), by_name);
  LockedSolution result{.packages = std::move(resolution->packages), .lock_text = write_lock(lock)};
  result.lock_changed = result.lock_text != old_text;
  if (must_fit) {
    auto changes = changes_of(locked, lock.packages);
    for (std::string& one : changed_sources(old_sources, rest.sources))
      changes.push_back(std::move(one));
    for (std::string& one : changed_wheels(old_wheels, rest.wheels))
      changes.push_back(std::move(one));
    for (std::string& one : changed_libraries(old_libraries, rest.libraries))
      changes.push_back(std::move(one));
    if (!changes.empty()) return lock_does_not_fit(lock_file, std::move(changes));
  }
  return result;
}

}  // namespace ros2wasm
