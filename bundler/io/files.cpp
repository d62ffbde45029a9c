// See files.hpp.
#include "bundler/io/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

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

}  // namespace

Diagnostic cannot_read(const fs::path& path, int errno_value) {
  return Diagnostic{.code = "R2W0210",
                    .kind = FailureKind::kEnvironment,
                    .message = "cannot read `" + path.string() + "`",
                    .why = {system_reason(errno_value)}};
}

Diagnostic cannot_write(const fs::path& path, int errno_value) {
  return Diagnostic{.code = "R2W0211",
                    .kind = FailureKind::kEnvironment,
                    .message = "cannot write `" + path.string() + "`",
                    .why = {system_reason(errno_value)}};
}

Outcome<std::string> read_file(const fs::path& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return cannot_read(path, errno);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return cannot_read(path, errno);
  if (S_ISDIR(status.st_mode)) return cannot_read(path, EISDIR);
  std::string bytes;
  std::size_t used = 0;
  bytes.resize(static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) + 1);
  for (;;) {
    if (used == bytes.size()) bytes.resize(bytes.size() * 2);
    const ssize_t got = ::read(file.get(), bytes.data() + used, bytes.size() - used);
    if (got < 0) {
      if (errno == EINTR) continue;
      return cannot_read(path, errno);
    }
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  bytes.resize(used);
  return bytes;
}

Outcome<Done> write_file(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) == bytes.size() && !error) {
    const auto old = read_file(path);
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
    if (error) return cannot_read(path, error.value());
    switch (status.type()) {
      case fs::file_type::directory:
        if (!fs::is_empty(path, error)) continue;
        if (error) return cannot_read(path, error.value());
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
  std::string path = (parent / (prefix + "XXXXXX")).string();
  if (::mkdtemp(path.data()) == nullptr) return cannot_write(parent, errno);
  return TemporaryDirectory(path);
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
