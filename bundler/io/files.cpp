// See files.hpp.
#include "bundler/io/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <system_error>
#include <utility>

#include "bundler/io/replaced_file.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// Closes a descriptor at the end of a scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

std::string system_reason(int errno_value) {
  return std::error_code(errno_value, std::generic_category()).message();
}

/// Only of what is neither a regular file nor a folder.
std::string kind_of_file(mode_t mode) {
  if (S_ISFIFO(mode)) return "it is a pipe, not a file";
  if (S_ISSOCK(mode)) return "it is a socket, not a file";
  return "it is a device, not a file";
}

std::string too_large(std::uint64_t at_most, std::uint64_t size) {
  return "it has " + std::to_string(size) + " bytes or more; of such a file at most " +
         std::to_string(at_most) + " are read";
}

/// Sockets cannot be opened at all; say so.
Diagnostic cannot_open(const fs::path& path, int errno_value) {
  struct stat status {};
  if (errno_value == ENXIO && ::stat(path.c_str(), &status) == 0)
    return cannot_read(path, kind_of_file(status.st_mode));
  return cannot_read(path, errno_value);
}

/// A directory that may not be written cannot lose entries: give the right back before removing.
void make_removable(const fs::path& path) {
  std::error_code ignored;
  if (fs::symlink_status(path, ignored).type() != fs::file_type::directory) return;
  fs::permissions(path, fs::perms::owner_all, fs::perm_options::add, ignored);
  for (fs::recursive_directory_iterator it(path, ignored), end; !ignored && it != end;
       it.increment(ignored)) {
    if (it->symlink_status(ignored).type() == fs::file_type::directory) {
      fs::permissions(it->path(), fs::perms::owner_all, fs::perm_options::add, ignored);
    }
  }
}

/// Somebody else removed it after its name was read: then it is not part of the tree.
bool is_gone(const fs::file_status& status, std::error_code& error) {
  const bool gone =
      status.type() == fs::file_type::not_found || error == std::errc::no_such_file_or_directory;
  if (gone) error.clear();
  return gone;
}

}  // namespace

Diagnostic cannot_read(const fs::path& path, std::string reason) {
  return Diagnostic{.code = "R2W0210",
                    .message = "cannot read `" + path.string() + "`",
                    .why = {std::move(reason)}};
}

Diagnostic cannot_read(const fs::path& path, int errno_value) {
  Diagnostic result = cannot_read(path, system_reason(errno_value));
  // A name that is mistyped is the caller's to mend: trying again, as CI does for disks and
  // networks, does not help.
  const bool is_name = errno_value == ENOENT || errno_value == ENOTDIR || errno_value == EISDIR ||
                       errno_value == ELOOP || errno_value == ENAMETOOLONG;
  if (!is_name) result.kind = FailureKind::kEnvironment;
  return result;
}

Diagnostic cannot_write(const fs::path& path, int errno_value) {
  return Diagnostic{.code = "R2W0211",
                    .kind = FailureKind::kEnvironment,
                    .message = "cannot write `" + path.string() + "`",
                    .why = {system_reason(errno_value)}};
}

bool is_absent(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::not_found;
}

Outcome<int> open_file_to_read(const fs::path& path, std::uint64_t at_most) {
  // A pipe without a writer must not be waited for.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return cannot_open(path, errno);
  struct stat status {};
  const bool regular = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  const auto size = static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0));
  if (regular && size <= at_most) return file;
  ::close(file);
  if (regular) return cannot_read(path, too_large(at_most, size));
  return S_ISDIR(status.st_mode) ? cannot_read(path, EISDIR)
                                 : cannot_read(path, kind_of_file(status.st_mode));
}

Outcome<std::string> read_file(const fs::path& path, std::uint64_t at_most) {
  const auto opened = open_file_to_read(path, at_most);
  if (!opened) return opened.errors();
  const Descriptor file(*opened);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return cannot_read(path, errno);
  const auto size = static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0));
  std::string bytes;
  std::uint64_t used = 0;
  try {
    bytes.resize(size + 1);  // one more, so that the end is seen
    for (;;) {
      if (used > at_most) return cannot_read(path, too_large(at_most, used));
      if (used == bytes.size()) bytes.resize(std::min(bytes.size() * 2, at_most + 1));
      const ssize_t got = ::read(file.get(), bytes.data() + used, bytes.size() - used);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return cannot_read(path, errno);
      if (got == 0) break;
      used += static_cast<std::uint64_t>(got);
    }
  } catch (const std::bad_alloc&) {
    return cannot_read(path, ENOMEM);
  }
  bytes.resize(used);
  return bytes;
}

Outcome<Done> write_file(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) == bytes.size() && !error) {
    const auto old = read_file(path, bytes.size());
    if (old && *old == bytes) return Done{};
  }
  auto file = ReplacedFile::begin(path);
  if (!file) return std::move(file).errors();
  if (auto written = file->append(bytes); !written) return written;
  return file->finish();
}

Outcome<Done> make_directories(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return cannot_write(path, error.value());
  return Done{};
}

Outcome<fs::path> absolute_path(const fs::path& path) {
  if (path.empty()) return cannot_read(path, ENOENT);
  if (path.is_absolute()) return path;
  std::error_code error;
  const fs::path here = fs::current_path(error);
  if (error == std::errc::no_such_file_or_directory)
    return cannot_read(path, "it is relative, and the current folder has been removed");
  if (error) return cannot_read(path, error.value());
  return here / path;
}

Outcome<fs::path> real_path(const fs::path& path) {
  const auto whole = absolute_path(path);
  if (!whole) return whole;
  std::error_code error;
  fs::path real = fs::weakly_canonical(*whole, error);
  if (error) return cannot_read(path, error.value());
  return real;
}

Outcome<Done> remove_tree(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) {
    make_removable(path);
    fs::remove_all(path, error);
  }
  if (error) return cannot_write(path, error.value());
  return Done{};
}

Outcome<std::vector<TreeEntry>> list_tree(const fs::path& root) {
  std::vector<TreeEntry> entries;
  std::error_code error;
  fs::recursive_directory_iterator it(root, error);
  if (error) return cannot_read(root, error.value());
  for (const fs::recursive_directory_iterator end; it != end; it.increment(error)) {
    const fs::path& path = it->path();
    TreeEntry entry{.path = path.lexically_relative(root).generic_string()};
    const fs::file_status status = it->symlink_status(error);
    if (is_gone(status, error)) continue;
    if (error) return cannot_read(path, error.value());
    switch (status.type()) {
      case fs::file_type::directory:
        if (const bool empty = fs::is_empty(path, error); !empty && !error) continue;
        entry.kind = FileKind::kDirectory;
        break;
      case fs::file_type::symlink:
        entry.kind = FileKind::kLink;
        entry.link_target = fs::read_symlink(path, error).string();
        break;
      case fs::file_type::regular:
        entry.executable = (status.permissions() & (fs::perms::owner_exec | fs::perms::group_exec |
                                                    fs::perms::others_exec)) != fs::perms::none;
        entry.size = fs::file_size(path, error);
        break;
      default:
        entry.kind = FileKind::kOther;
    }
    if (is_gone(status, error)) continue;
    if (error) return cannot_read(path, error.value());
    entries.push_back(std::move(entry));
  }
  if (error) return cannot_read(root, error.value());
  std::sort(entries.begin(), entries.end(),
            [](const TreeEntry& a, const TreeEntry& b) { return a.path < b.path; });
  return entries;
}

std::optional<fs::path> path_within(const fs::path& root, const fs::path& path) {
  std::error_code error;
  const fs::path real_root = fs::canonical(root, error);
  if (error) return std::nullopt;
  fs::path real = fs::canonical(path, error);
  if (error) return std::nullopt;
  const fs::path below = real.lexically_relative(real_root);
  if (below.empty() || *below.begin() == "..") return std::nullopt;
  return real;
}

Outcome<TemporaryDirectory> TemporaryDirectory::make(const fs::path& parent,
                                                     const std::string& prefix) {
  if (auto made = make_directories(parent); !made) return std::move(made).errors();
  constexpr std::string_view kRandom = "XXXXXX";
  const std::string name = prefix.substr(0, kLongestName - kRandom.size());
  std::string path = (parent / (name + std::string(kRandom))).string();
  if (::mkdtemp(path.data()) == nullptr) return cannot_write(parent, errno);
  return TemporaryDirectory(path);
}

Outcome<TemporaryDirectory> TemporaryDirectory::make(const std::string& prefix) {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  if (error) return cannot_write("$TMPDIR", error.value());
  return make(parent, prefix);
}

TemporaryDirectory::~TemporaryDirectory() {
  if (!path_.empty()) (void)remove_tree(path_);
}

TemporaryDirectory::TemporaryDirectory(TemporaryDirectory&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryDirectory& TemporaryDirectory::operator=(TemporaryDirectory&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

}  // namespace ros2wasm
