// `ros2wasm verify SITE|URL`: whether every byte of a site is the one it was packed with.
#include <filesystem>
#include <memory>
#include <optional>

#include "bundler/io/files.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/site/signature.hpp"
#include "bundler/verify/course_check.hpp"
#include "bundler/verify/site_check.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string site;
  std::string hash;
  std::string key;
};

std::uint64_t size_of(const SiteList& list) {
  std::uint64_t size = 0;
  for (const ListedFile& file : list.files) size += file.size;
  return size;
}

/// The signer of a site, as checked with the given key.
struct Signed {
  std::string key_id;
  std::string comment;
};

/// A public key's file, or its line itself. R2W0210, R2W0655.
Outcome<PublicKey> key_of(const std::string& given) {
  // A file of that name comes first.
  std::error_code error;
  if (given.starts_with("RW") && given.size() == 56 && !std::filesystem::exists(given, error))
    return read_public_key(given, given);
  const auto text = read_file(given, kMostOfText);
  if (!text) return text.errors();
  return read_public_key(*text, given);
}

/// R2W0654 there is no signature, R2W0656, R2W0657.
Outcome<Signed> signed_by(const PublicKey& key, const SiteCheck& check) {
  if (!check.signature)
    return Diagnostic{.code = "R2W0654",
                      .message = "the site is not signed",
                      .why = {std::string("it has no ") + kSignatureName},
                      .fix = {}};
  const auto signature = read_signature(*check.signature, kSignatureName);
  if (!signature) return signature.errors();
  if (auto fine = check_signature(*signature, key, check.site_json); !fine)
    return std::move(fine).errors();
  return Signed{.key_id = key_id_text(key.id), .comment = signature->trusted_comment};
}

void print_json(Context& context, const std::string& site, const SiteCheck& check,
                const std::optional<Signed>& signer, bool good) {
  JsonWriter json;
  json.begin_object().field("site", site).field("sha256", check.list.hash);
  json.key("files").unsigned_integer(check.list.files.size());
  json.key("bytes").unsigned_integer(size_of(check.list)).field_boolean("as_packed", good);
  if (signer) {
    json.key("signed").begin_object().field("key", signer->key_id);
    json.field("comment", signer->comment).end_object();
  }
  json.key("faults").unsigned_integer(check.faults.size()).key("unlisted").begin_array();
  for (const std::string& path : check.unlisted) json.string(path);
  json.end_array().end_object();
  context.console.result(json.text());
}

Diagnostic another_site(const std::string& wanted, const std::string& found) {
  return Diagnostic{.code = "R2W0652",
                    .message = "this is another site than the one that was asked for",
                    .why = {"its sha256 is " + found, "asked for was " + wanted},
                    .fix = {}};
}

int verify(Context& context, const Options& options) {
  std::string wanted = options.hash;
  if (wanted.starts_with("sha256:")) wanted.erase(0, 7);
  if (!options.hash.empty() &&
      (wanted.size() != 64 || wanted.find_first_not_of("0123456789abcdef") != std::string::npos)) {
    return context.console.fail(
        Diagnostic{.code = "R2W0902",
                   .kind = FailureKind::kCommandLine,
                   .message = "`" + options.hash + "` is not a sha256",
                   .why = {"it has 64 of the characters 0 to 9 and a to f, as `ros2wasm pack` and "
                           "the page show it"},
                   .fix = {}});
  }
  std::optional<PublicKey> key;
  if (!options.key.empty()) {
    auto read = key_of(options.key);
    if (!read) return context.console.fail(read.errors());
    key = std::move(*read);
  }
  const auto check =
      is_network_url(options.site)
          ? check_site_address(options.site, network_of(context.environment), key.has_value(),
                               context.cancellation, context.progress)
      : options.site.ends_with(".html")
          ? check_site_page(options.site, context.cancellation, context.progress)
      : is_course_of_ours(options.site)
          ? check_course_folder(options.site, context.cancellation, context.progress)
          : check_site_folder(options.site, context.cancellation, context.progress);
  if (!check) return context.console.fail(check.errors());
  Diagnostics faults = check->faults;
  if (!wanted.empty() && wanted != check->list.hash)
    faults.insert(faults.begin(), another_site(wanted, check->list.hash));
  std::optional<Signed> signer;
  if (key) {
    auto found = signed_by(*key, *check);
    if (found) {
      signer = std::move(*found);
    } else {
      faults.insert(faults.begin(), found.errors().begin(), found.errors().end());
    }
  }
  if (!check->unlisted.empty())
    context.console.report(unlisted_files(check->unlisted, options.site));
  if (context.json) print_json(context, options.site, *check, signer, faults.empty());
  if (!faults.empty()) return context.console.fail(faults);
  if (!context.json) {
    context.console.result(options.site + ": " + std::to_string(check->list.files.size()) +
                           " files, " + std::to_string(size_of(check->list)) +
                           " bytes, all as packed");
    context.console.result("sha256 " + check->list.hash);
    if (signer)
      context.console.result("signed with the key " + signer->key_id + ": " + signer->comment);
    if (!key && check->signature)
      context.console.remark("it carries a signature, which says nothing without --key");
  }
  return 0;
}

}  // namespace

CommandBody verify_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.required("SITE", options->site, "folder of a site, or the address of one");
  arguments.value("--hash", options->hash, "SHA256",
                  "what the site must be: the sha256 that `ros2wasm pack` printed");
  arguments.value("--key", options->key, "KEY",
                  "who must have signed the site: a public key of minisign, or its file");
  arguments.examples({"ros2wasm verify site", "ros2wasm verify site --key minisign.pub",
                      "ros2wasm verify https://example.org/lab/ --hash ..."});
  return [options](Context& context) { return verify(context, *options); };
}

}  // namespace ros2wasm
