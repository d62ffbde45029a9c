// The requests that a person makes to the pipeline.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bundler/build/compiler.hpp"
#include "bundler/plan/site_signature.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct PackRequest {
  std::string
      input;  ///< workspace.yaml, or a folder with or without one; empty: the current folder
  std::filesystem::path output;  ///< folder to write
  bool locked = false;           ///< fail rather than change ros2wasm.lock
  bool frozen = false;   ///< only the packages of ros2wasm.lock, which must fulfil what is asked
                         ///< (R2W0311); no channel is asked
  bool offline = false;  ///< nothing comes over the network
  bool with_channel = false;         ///< the packages of the channels lie beside the site
  bool plan_only = false;            ///< write nothing but the build cache
  bool plan_builds = false;          ///< of build(): it stops before something is built
  std::filesystem::path executable;  ///< of this program
  EnvironmentVariables variables;
  unsigned jobs = 0;            ///< compilers at once; 0: one per processor
  bool quick = false;           ///< larger programs, linked in a fraction of the time
  bool strict = false;          ///< what the launch file starts and no site can start is an error
  std::filesystem::path store;  ///< folder that sites share; empty: the site has all its files
  std::uint64_t max_file_size = 0;  ///< bytes; larger files are split into parts; 0: no limit
  bool precompress = false;         ///< a folder's files have compressed forms beside them
  std::filesystem::path built;      ///< where builds are kept; empty: in the cache
  std::string archive_limits;       ///< see extract_limits.hpp; empty: as the environment says
  LockUpdate update = {};           ///< what is chosen anew although the lock has it
  bool for_channel =
      false;  ///< packages that fail are listed, and no program is linked with plugins of others
  std::vector<NamedSource> more_sources = {};  ///< beside those of the manifest
  bool takes_carried = false;  ///< of a site that is made once more: the sources in it
  std::shared_ptr<const SiteSigner> signer;  ///< who signs the site; nobody when null
};

struct LockRequest {
  std::string input;        ///< as in PackRequest
  bool check_only = false;  ///< write nothing, ask no channel: does the lock fulfil what is asked?
  LockUpdate update;        ///< what is chosen anew although the lock has it
  bool offline = false;     ///< as in PackRequest
  std::filesystem::path executable;
  EnvironmentVariables variables;
};

}  // namespace ros2wasm
