// See site_signature.hpp.
#include "bundler/plan/site_signature.hpp"

#include <algorithm>
#include <utility>

#include "bundler/io/sha256.hpp"
#include "bundler/site/site_list.hpp"

namespace ros2wasm {
namespace {

void add(SitePlan& plan, const char* path, const char* reason, std::string bytes) {
  PlannedFile file{.path = path, .reason = reason, .bytes = std::move(bytes), .sha256 = {}};
  file.sha256 = sha256_hex(file.bytes);
  const auto after = std::find_if(plan.files.begin(), plan.files.end(),
                                  [&](const PlannedFile& one) { return one.path > file.path; });
  plan.files.insert(after, std::move(file));
}

}  // namespace

void sign_site(SitePlan& plan, const SiteSigner& signer) {
  const auto listed =
      std::find_if(plan.files.begin(), plan.files.end(),
                   [](const PlannedFile& one) { return one.path == kSiteJsonName; });
  const std::string comment = signer.comment.empty() ? "sha256 " + plan.sha256 : signer.comment;
  std::string signature = signature_text(signer.key, listed->bytes, comment);
  add(plan, kSignatureName, "signature of site.json, for `minisign -V`", std::move(signature));
  add(plan, kPublicKeyName, "the key of the signature, to compare",
      public_key_text(public_key_of(signer.key)));
}

}  // namespace ros2wasm
