// See site_responder.hpp.
#include "bundler/serve/site_responder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/serve/mime_types.hpp"
#include "bundler/serve/request_rules.hpp"
#include "bundler/serve/site_policy.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/site/site_list.hpp"
#include "bundler/verify/compressed_forms.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kReloadScriptPath = ".ros2wasm/reload.js";
constexpr std::string_view kReloadEventsPath = ".ros2wasm/events";
constexpr const char* kPolicyHeader = "Content-Security-Policy";

struct OpenFile {
  std::shared_ptr<const int> descriptor;
  std::uint64_t size = 0;
  std::string etag;
};

HttpResponse text_response(int status, std::string text) {
  return HttpResponse{.status = status,
                      .headers = {},
                      .content_type = "text/plain; charset=utf-8",
                      .body = std::move(text)};
}

OpenFile open_file(const Found& found) {
  struct stat status {};
  fstat(*found.file, &status);
  // The change time cannot be set back, so that packs with fixed modification times differ too.
  std::array<char, 96> etag{};
  std::snprintf(etag.data(), etag.size(), "\"%llx-%llx-%llx.%lx\"",
                static_cast<unsigned long long>(status.st_ino),
                static_cast<unsigned long long>(status.st_size),
                static_cast<unsigned long long>(status.st_ctim.tv_sec),
                static_cast<unsigned long>(status.st_ctim.tv_nsec));
  return OpenFile{.descriptor = found.file,
                  .size = static_cast<std::uint64_t>(status.st_size),
                  .etag = etag.data()};
}

/// One of a list such as `gzip, deflate, br;q=1.0`; not one that is refused with `q=0`.
bool accepts(std::string_view list, std::string_view encoding) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    std::string_view one = list.substr(0, end);
    list.remove_prefix(std::min(end + 1, list.size()));
    one.remove_prefix(std::min(one.find_first_not_of(" \t"), one.size()));
    const std::string_view name = one.substr(0, one.find_first_of("; \t"));
    if (name != encoding) continue;
    const std::size_t weight = one.find("q=0");
    return weight == std::string_view::npos ||
           one.find_first_of("123456789", weight + 3) != std::string_view::npos;
  }
  return false;
}

/// A form of a file that lies beside it.
struct Form {
  const Compression* compression = nullptr;
  Found file;
};

/// The best first.
std::vector<Form> forms_of(const Found& found) {
  std::vector<Form> forms;
  for (const Compression& one : kCompressions) {
    Found file = form_beside(found, one.ending);
    if (file.kind == Lookup::kFile) forms.push_back({&one, std::move(file)});
  }
  return forms;
}

/// The best that is asked for. A part is one of the file itself.
const Form* form_for(const HttpRequest& request, const std::vector<Form>& forms) {
  const auto accepted = request.header("Accept-Encoding");
  if (!accepted || request.header("Range")) return nullptr;
  const auto form = std::find_if(forms.begin(), forms.end(), [&](const Form& one) {
    return accepts(*accepted, one.compression->encoding);
  });
  return form == forms.end() ? nullptr : &*form;
}

/// A type of document that runs scripts when a browser opens it.
bool is_document(std::string_view type) {
  return type.starts_with("text/html") || type.find("xml") != std::string_view::npos;
}

/// The type is that of the name that was asked for, and the policy goes by the type: a link with
/// another name changes neither.
HttpResponse file_response(const HttpRequest& request, const Found& found) {
  const std::vector<Form> forms = forms_of(found);
  const Form* form = form_for(request, forms);
  const OpenFile file = open_file(form == nullptr ? found : form->file);
  const std::string type(
      mime_type(std::string_view(found.below).substr(found.below.rfind('/') + 1)));
  HttpResponse response{.status = 200,
                        .headers = {{"ETag", file.etag}, {"Accept-Ranges", "bytes"}},
                        .content_type = type,
                        .body = FileSlice{file.descriptor, 0, file.size}};
  // A document of a lab must not act as a page of the origin. The service worker does the same on
  // hosts that send no headers, for visitors who have opened the site before.
  if (is_document(type) && !found.is_page)
    response.headers.emplace_back(kPolicyHeader, "sandbox; " + std::string(site_policy()));
  if (form != nullptr)
    response.headers.emplace_back("Content-Encoding", std::string(form->compression->encoding));
  if (!forms.empty()) response.headers.emplace_back("Vary", "Accept-Encoding");
  const auto if_none_match = request.header("If-None-Match");
  if (if_none_match && matches_etag(*if_none_match, file.etag)) {
    response.status = 304;
    response.content_type.clear();
    response.body = std::string();
    return response;
  }
  const auto range_header = request.header("Range");
  const auto if_range = request.header("If-Range");
  if (!range_header || (if_range && *if_range != file.etag)) return response;
  const RangeResult asked = range_of(*range_header, file.size);
  const std::string size = std::to_string(file.size);
  switch (asked.answer) {
    case RangeAnswer::kWhole:
      break;
    case RangeAnswer::kPart:
      response.status = 206;
      response.body = FileSlice{file.descriptor, asked.range.first, asked.range.length};
      response.headers.emplace_back(
          "Content-Range", "bytes " + std::to_string(asked.range.first) + "-" +
                               std::to_string(asked.range.first + asked.range.length - 1) + "/" +
                               size);
      break;
    case RangeAnswer::kUnsatisfiable:
      response = text_response(416, "The file has " + size + " bytes.\n");
      response.headers.emplace_back("Content-Range", "bytes */" + size);
      break;
  }
  return response;
}

std::optional<std::string> text_of(const ServedPlace& place, const std::string& path,
                                   std::uint64_t at_most) {
  const Found found = find_served(place, path);
  if (found.kind != Lookup::kFile) return std::nullopt;
  auto text = read_file("/proc/self/fd/" + std::to_string(*found.file), at_most);
  if (!text) return std::nullopt;
  return std::move(*text);
}

/// The responses that differ in watch mode: the start page has the reload script, and site.json its
/// new hash.
std::optional<HttpResponse> watched_response(const SiteServing& serving, const std::string& path) {
  if (!serving.place.address.empty()) return std::nullopt;
  const bool description = path == "site.json";
  if (!description && !path.empty() && path != "index.html") return std::nullopt;
  const auto page = text_of(serving.place, "index.html", kMostOfData);
  if (!page) return std::nullopt;
  std::string text = with_reload_script(*page, serving.reload->state().version);
  if (description) {
    const auto packed = text_of(serving.place, "site.json", kMostOfSiteJson);
    if (!packed) return std::nullopt;
    text = with_page_hash(*packed, *page, text);
  }
  return HttpResponse{
      .status = 200,
      .headers = {},
      .content_type = std::string(mime_type(description ? "site.json" : "index.html")),
      .body = std::move(text)};
}

std::optional<HttpResponse> reload_response(const ReloadHub& reload, const std::string& path) {
  if (path == kReloadScriptPath) {
    return HttpResponse{.status = 200,
                        .headers = {},
                        .content_type = std::string(mime_type("reload.js")),
                        .body = std::string(reload_script())};
  }
  if (path == kReloadEventsPath) {
    return HttpResponse{
        .status = 200, .headers = {}, .content_type = "text/event-stream", .body = reload.events()};
  }
  return std::nullopt;
}

HttpResponse path_response(const SiteServing& serving, const HttpRequest& request,
                           const std::string& path) {
  if (serving.reload) {
    if (auto special = reload_response(*serving.reload, path)) return std::move(*special);
    if (auto special = watched_response(serving, path)) return std::move(*special);
  }
  if (path.empty() && !serving.place.address.empty()) {
    HttpResponse redirect = text_response(307, "The site is below this address.\n");
    redirect.headers.emplace_back("Location", "/" + percent_encoded(serving.place.address));
    return redirect;
  }
  const bool wants_folder = path.empty() || path.ends_with('/');
  const Found found = find_served(serving.place, wants_folder ? path + "index.html" : path);
  if (found.kind == Lookup::kFile) return file_response(request, found);
  // A folder's page has relative links, which need the slash.
  if (found.kind == Lookup::kFolder && !wants_folder &&
      find_served(serving.place, path + "/index.html").kind == Lookup::kFile) {
    HttpResponse redirect = text_response(308, "This page is a folder.\n");
    const std::string_view sent =
        std::string_view(request.target).substr(0, request.target.find_first_of("?#"));
    redirect.headers.emplace_back("Location",
                                  "." + std::string(sent.substr(sent.rfind('/'))) + "/");
    return redirect;
  }
  return text_response(404, "This site has no such file.\n");
}

HttpResponse bare_response(const SiteServing& serving, const HttpRequest& request) {
  if (serving.only_local_hosts && !is_local_host(request.header("Host").value_or("localhost"))) {
    return text_response(403,
                         "This server answers only to the name of this machine (localhost).\n"
                         "To serve under other names, start it with `--host 0.0.0.0`.\n");
  }
  if (request.method != "GET" && request.method != "HEAD") {
    HttpResponse refused = text_response(405, "Only GET and HEAD are answered.\n");
    refused.headers.emplace_back("Allow", "GET, HEAD");
    refused.headers.emplace_back("Connection", "close");  // whatever was sent is not read
    return refused;
  }
  const auto path = site_path_of(request.target);
  if (!path) return text_response(404, "This site has no such file.\n");
  return path_response(serving, request, *path);
}

}  // namespace

Outcome<Done> check_site(const std::filesystem::path& folder, CourseToo course_too) {
  std::error_code error;
  Diagnostic problem{.code = "R2W0612",
                     .message = "`" + folder.string() + "` is not a packed site"};
  if (!std::filesystem::exists(folder, error)) {
    problem.why.push_back("there is no such folder");
  } else if (!std::filesystem::is_directory(folder, error)) {
    problem.why.push_back("it is a file; a site is a folder");
  } else if (is_course_of_ours(folder)) {
    if (course_too == CourseToo::kYes) return Done{};
    problem.why.push_back("it is a course, whose labs are sites");
    problem.fix.push_back("name one of its labs: `" + (folder / "LAB").string() + "`");
  } else if (!std::filesystem::is_regular_file(folder / "site.json", error)) {
    problem.why.push_back("it has no site.json");
  } else if (!std::filesystem::is_regular_file(folder / "index.html", error)) {
    problem.why.push_back("it has no index.html");
  } else {
    return Done{};
  }
  // The manifest is the most likely mistake: offer what makes a site of it.
  const bool workspace = std::filesystem::is_regular_file(folder / "workspace.yaml", error);
  const bool manifest = folder.filename() == "workspace.yaml";
  if (workspace || manifest) {
    problem.why.push_back("it is a workspace, which must be packed first");
    problem.fix.push_back("ros2wasm pack " + folder.string() + " -o site && ros2wasm serve site");
  }
  return problem;
}

std::string site_version(const std::filesystem::path& folder) {
  const auto description = read_file(folder / "site.json", kMostOfSiteJson);
  return description ? sha256_hex(*description).substr(0, 16) : std::string("none");
}

HttpResponse site_response(const SiteServing& serving, const HttpRequest& request) {
  HttpResponse response = bare_response(serving, request);
  const bool live = std::holds_alternative<TextStream>(response.body);
  response.headers.emplace_back("Cache-Control", live ? "no-store" : "no-cache");
  response.headers.emplace_back("X-Content-Type-Options", "nosniff");
  const bool has_policy =
      std::any_of(response.headers.begin(), response.headers.end(),
                  [](const auto& header) { return header.first == kPolicyHeader; });
  if (!has_policy) response.headers.emplace_back(kPolicyHeader, std::string(site_policy()));
  if (serving.isolation) {
    response.headers.emplace_back("Cross-Origin-Opener-Policy", "same-origin");
    response.headers.emplace_back("Cross-Origin-Embedder-Policy", "require-corp");
    response.headers.emplace_back("Cross-Origin-Resource-Policy", "same-origin");
  }
  return response;
}

}  // namespace ros2wasm
