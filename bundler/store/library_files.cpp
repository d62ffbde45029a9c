// See library_files.hpp.
#include "bundler/store/library_files.hpp"

#include <algorithm>
#include <optional>

#include "bundler/channel/verified_files.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kWheelEnding = ".whl";

std::string address_in(const std::string& index, const std::string& file) {
  return index.ends_with('/') ? index + file : index + "/" + file;
}

/// Where the file lies once it is here.
WantedFile wanted_file(const LockedLibrary& library, const std::string& index,
                       const ChannelRoots& roots) {
  WantedFile wanted{.what = "the Python library `" + library.file + "`",
                    .url = address_in(index, library.file),
                    .place = {},
                    .size = 0,
                    .sha256 = library.sha256,
                    .md5 = {}};
  // Beside the archives of packages, and looked after as they are.
  wanted.place = is_network_url(index) ? roots.cache / "archives" / library.sha256.substr(0, 2) /
                                             library.sha256 / "package.whl"
                                       : roots.working_directory / index / library.file;
  return wanted;
}

/// One error for all that is not here: the reasons are mostly the same.
Diagnostic not_here(const std::vector<const LockedLibrary*>& missing, const std::string& index,
                    std::vector<std::string> reasons) {
  const bool is_one = missing.size() == 1;
  Diagnostic made{
      .code = "R2W0246",
      .kind = FailureKind::kEnvironment,
      .message =
          is_one ? "the Python library `" + missing.front()->project + "` is not on this machine"
                 : std::to_string(missing.size()) + " Python libraries are not on this machine"};
  for (const LockedLibrary* one : missing)
    made.why.push_back("`" + one->project + "` " + one->version + " is " + one->file);
  made.why.push_back(
      "they come from " + index +
      ", which `python: index:` of workspace.yaml can change, or leave out with `none`");
  std::sort(reasons.begin(), reasons.end());
  reasons.erase(std::unique(reasons.begin(), reasons.end()), reasons.end());
  constexpr std::size_t kMostReasons = 3;
  if (reasons.size() > kMostReasons) reasons.resize(kMostReasons);
  for (std::string& one : reasons) made.why.push_back(std::move(one));
  made.fix.emplace_back("ros2wasm cache fetch ros2wasm.lock");
  return made;
}

Outcome<Done> bring_libraries(const std::vector<LockedLibrary>& libraries, const std::string& index,
                              const ChannelRoots& roots, const Cancellation& cancellation) {
  Diagnostics errors;
  std::vector<const LockedLibrary*> missing;
  std::vector<std::string> reasons;
  const auto fail = [&](const LockedLibrary& library, Diagnostic error) {
    if (error.code == "R2W0220") return errors.push_back(std::move(error));
    missing.push_back(&library);
    reasons.push_back(error.why.empty() ? error.message : error.why.front());
  };
  if (is_network_url(index)) {
    std::vector<WantedFile> wanted;
    for (const LockedLibrary& one : libraries) wanted.push_back(wanted_file(one, index, roots));
    bring_verified(wanted, roots.network, cancellation, [&](std::size_t i, Outcome<Done> outcome) {
      if (!outcome) fail(libraries[i], std::move(outcome).errors().front());
    });
    if (cancellation.requested()) return interrupted();
    std::sort(missing.begin(), missing.end(), [](const LockedLibrary* a, const LockedLibrary* b) {
      return a->project < b->project;
    });
  } else {
    for (const LockedLibrary& one : libraries) {
      const WantedFile wanted = wanted_file(one, index, roots);
      if (auto fault = file_fault(wanted, wanted.place)) fail(one, *std::move(fault));
    }
  }
  if (!missing.empty()) errors.push_back(not_here(missing, index, std::move(reasons)));
  if (!errors.empty()) return errors;
  return Done{};
}

}  // namespace

Outcome<Done> fetch_libraries(const std::vector<LockedLibrary>& libraries, const std::string& index,
                              const ChannelRoots& roots, const Cancellation& cancellation) {
  return bring_libraries(libraries, index, roots, cancellation);
}

Outcome<std::vector<LibraryFiles>> read_libraries(const std::vector<LockedLibrary>& libraries,
                                                  const std::string& index,
                                                  const ChannelRoots& roots,
                                                  const ExtractLimits& limits,
                                                  const Cancellation& cancellation) {
  if (auto brought = bring_libraries(libraries, index, roots, cancellation); !brought)
    return std::move(brought).errors();
  std::vector<LibraryFiles> result;
  Diagnostics errors;
  for (const LockedLibrary& one : libraries) {
    LibraryFiles files{.locked = one, .wheel = {}, .shared = {}};
    const fs::path place = wanted_file(one, index, roots).place;
    if (one.file.ends_with(kWheelEnding)) {
      const auto name = wheel_name(one.file);
      auto wheel =
          name
              ? read_wheel(place, *name, limits)
              : Outcome<Wheel>(Diagnostic{
                    .code = "R2W0119", .message = "`" + one.file + "` is not the name of a wheel"});
      if (!wheel) append(errors, wheel.errors());
      if (wheel) files.wheel = std::move(*wheel);
    } else {
      auto shared = read_shared_libraries(place, one.file, limits);
      if (!shared) append(errors, shared.errors());
      if (shared) files.shared = std::move(*shared);
    }
    result.push_back(std::move(files));
  }
  if (!errors.empty()) return errors;
  return result;
}

}  // namespace ros2wasm
