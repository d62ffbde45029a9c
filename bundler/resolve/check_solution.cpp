// check_solution() of solve.hpp: whether given packages fulfil a request, edge by edge. Pure.
#include <algorithm>
#include <map>
#include <optional>

#include "bundler/resolve/solve.hpp"
#include "bundler/resolve/virtual_packages.hpp"
#include "workspace_schema/conda/match_spec.hpp"

namespace ros2wasm {
namespace {

Diagnostic fault(std::string message, const std::optional<SourceSpan>& span = {}) {
  return Diagnostic{.code = "R2W0311", .message = std::move(message), .span = span};
}

class Checker {
 public:
  Checker(const std::vector<PackageRecord>& packages, const std::vector<PackageRecord>& built_here)
      : virtual_(virtual_packages()) {
    virtual_.insert(virtual_.end(), built_here.begin(), built_here.end());
    add(packages);
    add(virtual_);
  }

  /// `who` needs (or, where `limiting` is given, that one limits others to) `text`.
  void require(const std::string& who, const std::string& text,
               const PackageRecord* limiting = nullptr,
               const std::optional<SourceSpan>& span = {}) {
    const auto spec = MatchSpec::parse(text);
    if (!spec) {
      faults_.push_back(fault(who + " `" + text + "`: " + spec.errors().front().message, span));
      return;
    }
    bool match_there = false;
    const PackageRecord* other = nullptr;
    const auto look_at = [&](const PackageRecord& record) {
      if (&record == limiting || !spec->name().matches(record.name)) return;
      if (spec->matches(record)) {
        match_there = true;
      } else {
        other = &record;
      }
    };
    if (const auto name = spec->exact_name()) {
      if (const auto found = by_name_.find(*name); found != by_name_.end()) look_at(*found->second);
    } else {
      for (const auto& [name_of_record, record] : by_name_) look_at(*record);
    }
    if (limiting != nullptr ? other == nullptr : match_there) return;
    const std::string instead =
        other == nullptr ? "nothing like it is there"
                         : other->name + " " + other->version + " " + other->build + " is there";
    faults_.push_back(fault(who + " `" + text + "`, but " + instead, span));
  }

  Diagnostics take() { return std::move(faults_); }

 private:
  void add(const std::vector<PackageRecord>& packages) {
    for (const PackageRecord& record : packages) {
      if (!by_name_.emplace(record.name, &record).second) {
        faults_.push_back(fault("`" + record.name + "` is there twice"));
      }
    }
  }

  std::vector<PackageRecord> virtual_;
  std::map<std::string, const PackageRecord*, std::less<>> by_name_;
  Diagnostics faults_;
};

}  // namespace

Diagnostics check_solution(const std::vector<RequestedSpec>& specs,
                           const std::vector<PackageRecord>& packages,
                           const std::vector<PackageRecord>& built_here) {
  Checker checker(packages, built_here);
  for (const RequestedSpec& spec : specs) {
    checker.require((spec.origin.empty() ? "the workspace" : spec.origin) + " asks for", spec.text,
                    nullptr, spec.span);
  }
  for (const PackageRecord& record : packages) {
    const std::string who = record.name + " " + record.version;
    for (const std::string& text : record.depends) checker.require(who + " needs", text);
    for (const std::string& text : record.constrains)
      checker.require(who + " allows only", text, &record);
  }
  return checker.take();
}

}  // namespace ros2wasm
