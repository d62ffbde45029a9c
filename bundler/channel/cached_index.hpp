// The result of a scan of a repodata.json, as bytes that can be stored in a file: a header, the
// text, and a table of names with the places of their records. Pure. Only this program on this
// machine reads them; whatever does not check out counts as absent.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bundler/channel/repodata_scan.hpp"
#include "bundler/io/mapped_file.hpp"

namespace ros2wasm {

/// Room for the header, in front of the text.
inline constexpr std::size_t kKeptHeaderSize = 128;

/// Collects the records while their text goes by.
class KeptTable {
 public:
  void add(const FoundRecord& found);
  /// The table, which belongs behind the text.
  [[nodiscard]] std::string bytes(std::string_view info, std::string_view removed) const;

 private:
  struct Span {
    std::uint64_t offset = 0;
    std::uint32_t length = 0;
    std::uint32_t conda = 0;
    std::uint64_t hash = 0;
  };
  std::unordered_map<std::string, std::vector<Span>> spans_;
};

/// For what begins with kKeptHeaderSize bytes, then `text_size` bytes of text, then the table.
[[nodiscard]] std::string kept_header(const FileIdentity& source, std::uint64_t text_size,
                                      std::string_view table);

/// The state of the file that a kept index was made from; nothing when its header is damaged.
[[nodiscard]] std::optional<FileIdentity> kept_source(std::string_view bytes);

class KeptIndex {
 public:
  /// Nothing when the bytes are damaged, of another form or made from another state of the source.
  [[nodiscard]] static std::optional<KeptIndex> open(std::string_view bytes,
                                                     const FileIdentity& source);

  [[nodiscard]] std::span<const std::string_view> names() const { return names_; }
  [[nodiscard]] std::string_view info() const { return info_; }
  [[nodiscard]] std::string_view removed() const { return removed_; }

  struct Record {
    std::string_view text;  ///< `"x-1.0-0.conda": {...}`
    bool conda = false;
  };
  /// Those of the name with this place in names(); nothing when one of them is damaged.
  [[nodiscard]] std::optional<std::vector<Record>> records(std::size_t name) const;

 private:
  std::string_view text_;
  std::string_view entries_;
  std::string_view spans_;
  std::string_view info_;
  std::string_view removed_;
  std::vector<std::string_view> names_;
};

}  // namespace ros2wasm
