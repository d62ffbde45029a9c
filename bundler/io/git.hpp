// The program git, for reading repositories of strangers: without hooks, filters, prompts and the
// settings of the user or the machine. An edge: processes, network and disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

enum class GitObjectKind { kFile, kExecutable, kLink, kCommit };

/// One entry of a tree. A kCommit is a submodule.
struct GitEntry {
  std::string path;  ///< as it is in the tree: nobody has judged it
  GitObjectKind kind = GitObjectKind::kFile;
  std::string object;      ///< its hash
  std::uint64_t size = 0;  ///< of a file or a link
};

/// A submodule as .gitmodules names it.
struct GitSubmodule {
  std::string path;
  std::string url;
};

/// A bare repository that holds what fetch() has brought.
class GitRepository {
 public:
  /// `address` is one of git's, or a folder. `folder` must not exist; its parent must be empty but
  /// for such folders. `most_bytes` is the limit of each file that git writes, and thus of what a
  /// server sends. R2W0910 when git is not installed.
  [[nodiscard]] static Outcome<GitRepository> make(const std::string& address,
                                                   const std::filesystem::path& folder,
                                                   std::uint64_t most_bytes,
                                                   const Cancellation& cancellation);

  /// Brings the newest commit that `revision` names, without its history, and gives its hash; an
  /// empty revision names the default branch. R2W0251 the repository cannot be had, R2W0252 it has
  /// no such revision.
  [[nodiscard]] Outcome<std::string> fetch(const std::string& revision) const;
  /// The hash of the tree of a commit.
  [[nodiscard]] Outcome<std::string> tree_of(const std::string& commit) const;
  /// All of it, sorted by path.
  [[nodiscard]] Outcome<std::vector<GitEntry>> entries(const std::string& commit) const;
  [[nodiscard]] Outcome<std::vector<GitSubmodule>> submodules(const std::string& commit) const;
  /// Writes the files of a commit into `folder`, which is empty. Their names must have been judged.
  [[nodiscard]] Outcome<Done> check_out(const std::string& commit,
                                        const std::filesystem::path& folder) const;

 private:
  struct Answer {
    int exit_code = 0;
    std::string output;
    std::string error;
  };
  GitRepository(std::string address, std::filesystem::path folder, std::uint64_t most_bytes,
                Cancellation cancellation)
      : address_(std::move(address)),
        folder_(std::move(folder)),
        most_bytes_(most_bytes),
        cancellation_(cancellation) {}
  [[nodiscard]] Outcome<Answer> run(std::vector<std::string> arguments) const;
  /// The same, when a failure is git's and not the repository's: R2W0251.
  [[nodiscard]] Outcome<std::string> output_of(std::vector<std::string> arguments) const;
  [[nodiscard]] Outcome<Answer> bring(const std::string& what) const;
  [[nodiscard]] Diagnostic no_such_revision(const std::string& revision) const;

  std::string address_;
  std::filesystem::path folder_;
  std::uint64_t most_bytes_;
  Cancellation cancellation_;
};

/// Whether the text is the whole hash of a commit.
[[nodiscard]] bool is_commit_hash(std::string_view text);

}  // namespace ros2wasm
