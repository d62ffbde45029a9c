// The signature of a site and the key to compare, beside the files that site.json lists. Pure.
#pragma once

#include <string>

#include "bundler/render/site_plan.hpp"
#include "bundler/site/signature.hpp"

namespace ros2wasm {

struct SiteSigner {
  SecretKey key;
  std::string comment;  ///< signed too; empty: the site's sha256
};

/// Adds both; the site's sha256 stays what it is without them.
void sign_site(SitePlan& plan, const SiteSigner& signer);

}  // namespace ros2wasm
