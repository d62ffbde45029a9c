// See cache_place.hpp.
#include "bundler/store/cache_place.hpp"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <vector>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kOwnPlace = "set XDG_CACHE_HOME to a folder that only you can write to";

/// The home folder of the user whose rights the program has; empty when the system knows none.
fs::path home_of_user() {
  constexpr std::size_t kMostOfEntry = std::size_t{16} << 10U;
  std::vector<char> buffer(kMostOfEntry);
  passwd entry{};
  passwd* found = nullptr;
  if (::getpwuid_r(::geteuid(), &entry, buffer.data(), buffer.size(), &found) != 0 ||
      found == nullptr || found->pw_dir == nullptr)
    return {};
  const fs::path home = found->pw_dir;
  std::error_code error;
  return home.is_absolute() && home != "/" && fs::is_directory(home, error) ? home : fs::path();
}

fs::path place_of(const std::map<std::string, std::string>& variables) {
  const auto absolute = [&](const char* name) {
    const auto found = variables.find(name);
    const bool is_good = found != variables.end() && fs::path(found->second).is_absolute();
    return is_good ? fs::path(found->second) : fs::path();
  };
  if (const fs::path cache = absolute("XDG_CACHE_HOME"); !cache.empty()) return cache / "ros2wasm";
  fs::path home = absolute("HOME");
  if (home.empty()) home = home_of_user();
  return home.empty() ? home : home / ".cache" / "ros2wasm";
}

Diagnostic unsafe(const fs::path& place, std::string why, std::vector<std::string> fix) {
  return Diagnostic{.code = "R2W0244",
                    .kind = FailureKind::kEnvironment,
                    .message = "the cache `" + place.string() + "` is not used",
                    .why = {std::move(why), "whoever can write there can exchange packages"},
                    .fix = std::move(fix)};
}

}  // namespace

Outcome<fs::path> cache_directory(const std::map<std::string, std::string>& variables) {
  const fs::path place = place_of(variables);
  if (place.empty()) {
    return Diagnostic{
        .code = "R2W0244",
        .kind = FailureKind::kEnvironment,
        .message = "there is no place for the cache",
        .why = {"neither XDG_CACHE_HOME nor HOME is set, and the system knows no home "
                "folder of this user"},
        .fix = {kOwnPlace}};
  }
  // When the folder cannot be made, the first code that needs it reports the error.
  if (make_directories(place.parent_path())) ::mkdir(place.c_str(), 0700);
  struct stat status {};
  if (::stat(place.c_str(), &status) != 0) return place;
  if (status.st_uid != ::geteuid())
    return unsafe(place,
                  "it belongs to another user (number " + std::to_string(status.st_uid) + ")",
                  {kOwnPlace});
  if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return unsafe(place, "other users can write to it",
                  {"chmod go-w " + place.string(), kOwnPlace});
  return place;
}

}  // namespace ros2wasm
