// How a site is cited, as others read it. For manifests with `citation`. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct PersonName {
  std::string family;
  std::string given;  ///< empty: `family` is the whole name, of a person or a group
};

/// `Family, Given`, else the last word is the family name. One word is a whole name.
[[nodiscard]] PersonName person_name(const std::string& name);

/// CITATION.cff, Citation File Format 1.2.0.
[[nodiscard]] std::string citation_cff(const Manifest& manifest);

/// A file of the site, as the metadata lists it.
struct DescribedFile {
  std::string path;
  std::string reason;
  std::string sha256;      ///< empty where it is not known yet
  std::uint64_t size = 0;  ///< likewise 0
};

/// ro-crate-metadata.json, RO-Crate 1.1. `files` sorted by path.
[[nodiscard]] std::string ro_crate_metadata(const Manifest& manifest,
                                            const std::vector<DescribedFile>& files);

}  // namespace ros2wasm
