// See package_xml.hpp. Pure.
#include "workspace_schema/schema/package_xml.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "workspace_schema/base/names.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/xml_reader.hpp"

namespace ros2wasm {
namespace {

using Kind = DependencyKind;

/// The meaning of a dependency element, and the formats that allow it.
struct DependencyElement {
  std::string_view name;
  int first_format;
  int last_format;
  std::vector<Kind> kinds;
  std::string_view instead;  ///< element to write in the other formats
};

const std::vector<DependencyElement>& dependency_elements() {
  static const std::vector<DependencyElement> kElements{
      {"build_depend", 1, 3, {Kind::kBuild}, ""},
      {"buildtool_depend", 1, 3, {Kind::kBuildTool}, ""},
      {"run_depend", 1, 1, {Kind::kBuildExport, Kind::kExec}, "exec_depend"},
      {"test_depend", 1, 3, {Kind::kTest}, ""},
      {"depend", 2, 3, {Kind::kBuild, Kind::kBuildExport, Kind::kExec}, "build_depend"},
      {"build_export_depend", 2, 3, {Kind::kBuildExport}, "run_depend"},
      {"buildtool_export_depend", 2, 3, {Kind::kBuildToolExport}, "buildtool_depend"},
      {"exec_depend", 2, 3, {Kind::kExec}, "run_depend"},
      {"doc_depend", 2, 3, {Kind::kDoc}, ""},
  };
  return kElements;
}

constexpr std::array<std::string_view, 13> kOtherElements{
    "name",     "version", "description", "maintainer",   "license",         "url",     "author",
    "conflict", "replace", "export",      "group_depend", "member_of_group", "ros2wasm"};

std::string folded_space(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\t' || c == '\r') {
      if (!out.empty() && out.back() != ' ') out += ' ';
    } else {
      out += c;
    }
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

/// Three numbers with dots between.
bool is_package_version(std::string_view text) {
  int numbers = 0;
  bool digit_before = false;
  for (const char c : text) {
    if (c >= '0' && c <= '9') {
      if (!digit_before) ++numbers;
      digit_before = true;
    } else if (c == '.' && digit_before) {
      digit_before = false;
    } else {
      return false;
    }
  }
  return numbers == 3 && digit_before;
}

/// Reads one package element; collects all mistakes.
class Reader {
 public:
  Reader(const XmlElement& root, const std::string& file, const ConditionVariables& variables)
      : root_(root), variables_(variables) {
    package_.file = file;
  }

  Outcome<PackageXml> read() {
    if (root_.name != "package") {
      error("R2W0121",
            "the outermost element of a package.xml is `<package>`, here it is `<" + root_.name +
                ">`",
            root_.span, "expected `<package format=\"3\">`");
      return errors_;
    }
    read_format();
    package_.name = single("name");
    package_.version = single("version");
    check_name_and_version();
    for (const XmlElement& element : root_.children) read_element(element);
    read_export();
    if (!errors_.empty()) return errors_;
    return std::move(package_);
  }

 private:
  Diagnostic& error(DiagnosticCode code, std::string message, const SourceSpan& span,
                    std::string label = {}) {
    errors_.push_back(Diagnostic{
        .code = code, .message = std::move(message), .span = span, .label = std::move(label)});
    return errors_.back();
  }

  void read_format() {
    const std::string format = root_.attribute("format");
    if (format.empty() || format == "1") return;
    if (format == "2" || format == "3") {
      package_.format = format.front() - '0';
      return;
    }
    package_.format = 3;
    error("R2W0121", "package.xml format `" + format + "` is not known", root_.span,
          "formats 1, 2 and 3 exist")
        .fix.push_back("<package format=\"3\">");
  }

  /// The text of an element that must be there exactly once.
  Spanned<std::string> single(std::string_view name) {
    const XmlElement* found = nullptr;
    for (const XmlElement& element : root_.children) {
      if (element.name != name) continue;
      if (found != nullptr) {
        error("R2W0121", "`<" + std::string(name) + ">` appears twice in the package.xml",
              element.span, "the first is in line " + std::to_string(found->span.line));
        continue;
      }
      found = &element;
    }
    if (found == nullptr) {
      error("R2W0121", "the package.xml has no `<" + std::string(name) + ">`", root_.span,
            "inside this element");
      return {};
    }
    if (found->text.empty()) {
      error("R2W0121", "`<" + std::string(name) + ">` is empty", found->span);
      return {};
    }
    return {.value = found->text, .span = found->text_span};
  }

  void check_name_and_version() {
    if (!package_.name.value.empty()) {
      if (const auto fault = package_name_fault(package_.name.value)) {
        Diagnostic& bad =
            error("R2W0122", "`" + package_.name.value + "` is not a package name: " + fault->why,
                  package_.name.span);
        bad.why.push_back(fault->rule);
        if (fault->better) bad.fix.push_back("<name>" + *fault->better + "</name>");
      }
    }
    if (!package_.version.value.empty() && !is_package_version(package_.version.value)) {
      error("R2W0122", "`" + package_.version.value + "` is not a package version",
            package_.version.span, "three numbers with dots between, such as 1.2.3");
    }
  }

  [[nodiscard]] bool condition_holds(const XmlElement& element) {
    const std::string condition = element.attribute("condition");
    if (condition.empty()) return true;
    const auto holds = evaluate_condition(condition, variables_);
    if (holds) return *holds;
    error("R2W0123", "the condition `" + condition + "` cannot be read", element.span)
        .why.push_back(
            "a condition compares values: `$ROS_VERSION == 2`, `$ROS_DISTRO >= humble`, joined by "
            "`and`, `or` and parentheses");
    return false;
  }

  void read_element(const XmlElement& element) {
    const auto& known = dependency_elements();
    const auto dependency =
        std::find_if(known.begin(), known.end(),
                     [&](const DependencyElement& d) { return d.name == element.name; });
    if (dependency != known.end()) {
      read_dependency(element, *dependency);
    } else if (element.name == "license") {
      if (!element.text.empty())
        package_.licenses.push_back({.value = element.text, .span = element.text_span});
    } else if (element.name == "maintainer") {
      package_.maintainers.push_back(element.text);
    } else if (element.name == "description") {
      package_.description = folded_space(element.text);
    } else if (element.name == "member_of_group" || element.name == "group_depend") {
      read_group(element);
    } else if (std::find(kOtherElements.begin(), kOtherElements.end(), element.name) ==
               kOtherElements.end()) {
      unknown_element(element);
    }
  }

  void read_group(const XmlElement& element) {
    if (!condition_holds(element)) return;
    auto& groups =
        element.name == "group_depend" ? package_.group_depends : package_.member_of_groups;
    groups.push_back({.value = element.text, .span = element.text_span});
  }

  void unknown_element(const XmlElement& element) {
    std::vector<std::string> names(kOtherElements.begin(), kOtherElements.end());
    for (const DependencyElement& d : dependency_elements()) {
      if (package_.format >= d.first_format && package_.format <= d.last_format)
        names.emplace_back(d.name);
    }
    Diagnostic& unknown =
        error("R2W0121", "a package.xml has no element `<" + element.name + ">`", element.span);
    if (const auto near = nearest(element.name, names)) {
      unknown.fix.push_back("<" + *near + ">" + element.text + "</" + *near + ">");
    }
  }

  void read_dependency(const XmlElement& element, const DependencyElement& meaning) {
    if (package_.format < meaning.first_format || package_.format > meaning.last_format) {
      Diagnostic& misplaced =
          error("R2W0121",
                "`<" + element.name + ">` does not exist in package.xml format " +
                    std::to_string(package_.format),
                element.span);
      if (!meaning.instead.empty()) {
        const std::string instead(meaning.instead);
        misplaced.fix.push_back("<" + instead + ">" + element.text + "</" + instead + ">");
      }
      return;
    }
    if (!condition_holds(element)) return;
    if (element.text.empty()) {
      error("R2W0121", "`<" + element.name + ">` names no package", element.span);
      return;
    }
    PackageDependency dependency{.name = {.value = element.text, .span = element.text_span}};
    for (const std::string_view limit : {"lt", "lte", "eq", "gte", "gt"}) {
      const std::string version = element.attribute("version_" + std::string(limit));
      if (!version.empty()) dependency.version_limits.emplace(limit, version);
    }
    for (const Kind kind : meaning.kinds) {
      dependency.kind = kind;
      package_.dependencies.push_back(dependency);
    }
  }

  void read_export() {
    const XmlElement* exported = root_.child("export");
    if (exported == nullptr) return;
    for (const XmlElement& element : exported->children) {
      if (element.name == "build_type" && condition_holds(element))
        package_.build_type = element.text;
    }
  }

  const XmlElement& root_;
  const ConditionVariables& variables_;
  PackageXml package_{};
  Diagnostics errors_;
};

}  // namespace

std::vector<std::string> PackageXml::names_of(std::initializer_list<DependencyKind> kinds) const {
  std::set<std::string> names;
  for (const PackageDependency& dependency : dependencies) {
    if (std::find(kinds.begin(), kinds.end(), dependency.kind) != kinds.end())
      names.insert(dependency.name.value);
  }
  return {names.begin(), names.end()};
}

ConditionVariables ros_condition_variables(std::string_view distro) {
  return {{"ROS_VERSION", "2"}, {"ROS_DISTRO", std::string(distro)}, {"ROS_PYTHON_VERSION", "3"}};
}

Outcome<PackageXml> parse_package_xml(std::string_view text, const std::string& file,
                                      const ConditionVariables& variables) {
  const Outcome<XmlElement> root = parse_xml(text, file);
  if (!root) return root.errors();
  return Reader(*root, file, variables).read();
}

}  // namespace ros2wasm
