// Which packages of a workspace are not built, and why. Pure.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bundler/workspace/build_order.hpp"

namespace ros2wasm {

/// Why a package is not part of the site.
struct LeftOutReason {
  std::vector<std::string> chain;  ///< the nearest cause first, the last one at its end
  Diagnostic warning;              ///< R2W0514 or R2W0519
};

/// By the index of the package.
using LeftOutPackages = std::map<std::size_t, LeftOutReason>;

/// The packages that are skipped: those of other build types than these (R2W0514), those that
/// cannot be built without a package that neither the workspace nor a channel has (R2W0519), and
/// those that need one of them (R2W0514). When nothing would remain, no package is skipped for what
/// it lacks: that is an error then (R2W0513).
[[nodiscard]] LeftOutPackages left_out_packages(const std::vector<LocalPackage>& packages,
                                                const BuildOrder& order, const KnownNames& known,
                                                std::string_view distro,
                                                const std::vector<std::string>& build_types);

/// The build dependencies of a package that neither the workspace nor a channel has, each name
/// once; empty for a package in Python.
[[nodiscard]] std::vector<const PackageDependency*> lacking_dependencies(
    const LocalPackage& package, const std::vector<LocalPackage>& packages, const KnownNames& known,
    std::string_view distro);

/// The messages for a package that is built although it has a missing dependency, when its build
/// fails for that reason.
struct Lack {
  LeftOutReason reason;  ///< when others are built: R2W0519
  Diagnostics missing;   ///< when none is: R2W0513, errors
};
using Lacks = std::map<std::size_t, Lack>;  ///< by the index of the package

[[nodiscard]] Lacks packages_with_lacks(const std::vector<LocalPackage>& packages,
                                        const LeftOutPackages& left_out, const KnownNames& known,
                                        std::string_view distro);

/// The reasons by the names of the packages, the nearest cause first.
using LeftOutChains = std::map<std::string, std::vector<std::string>>;

/// The skipped package among `needs` (in the order of building) that a message names.
[[nodiscard]] std::optional<std::size_t> nearest_left_out(const std::vector<std::size_t>& needs,
                                                          const LeftOutPackages& left_out);

/// The reason for a package whose CMakeLists.txt asks for a package that neither the workspace nor
/// a channel has. `error`: R2W0507.
[[nodiscard]] LeftOutReason left_out_by_cmake(const LocalPackage& package, const Diagnostic& error);

/// The reason of a package that needs one which is skipped.
[[nodiscard]] LeftOutReason left_out_with(const LocalPackage& package, const LocalPackage& needed,
                                          const LeftOutReason& reason);

[[nodiscard]] LeftOutChains chains_by_name(const std::vector<LocalPackage>& packages,
                                           const LeftOutPackages& left_out);

}  // namespace ros2wasm
