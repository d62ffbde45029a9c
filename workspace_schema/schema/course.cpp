// See course.hpp.
#include "workspace_schema/schema/course.hpp"

#include <set>

#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {
namespace {

/// Folders of a course that are no labs.
constexpr std::string_view kReserved = "objects";

const std::vector<KeyRow>& course_keys() {
  static const std::vector<KeyRow> kKeys{{"schema", {}},
                                         {"name", {"id"}},
                                         {"title", {"heading"}},
                                         {"text", {"description", "summary"}},
                                         {"labs", {"workspaces", "sites", "lessons"}}};
  return kKeys;
}

const std::vector<KeyRow>& lab_keys() {
  static const std::vector<KeyRow> kKeys{{"workspace", {"path", "folder", "manifest"}},
                                         {"name", {"id"}},
                                         {"title", {"heading"}},
                                         {"description", {"text", "summary"}}};
  return kKeys;
}

void keep(std::optional<Spanned<std::string>> found, std::string& target) {
  if (found) target = std::move(found->value);
}

/// The last folder of a path: `week1/talker/workspace.yaml` is that of talker.
std::string folder_name(std::string path) {
  constexpr std::string_view kManifest = "/workspace.yaml";
  if (path.ends_with(kManifest)) path.resize(path.size() - kManifest.size());
  while (path.ends_with('/')) path.pop_back();
  return path.substr(path.rfind('/') + 1);
}

bool check_schema(Binder& binder, const YamlNode& root) {
  const YamlNode* node = value_of(root, "schema");
  if (node == nullptr) {
    if (Diagnostic* missing = binder.missing(root, "the course", "schema")) {
      missing->code = "R2W0107";
      missing->fix.push_back("write `schema: 1` as the first line");
    }
    return true;
  }
  if (node->kind == YamlKind::kScalar && node->text == "1") return true;
  binder.error("R2W0107", "`schema` must be a number that ros2wasm knows", node->range,
               "this ros2wasm reads schema 1");
  return false;
}

std::optional<CourseLab> read_lab(Binder& binder, const YamlNode& node) {
  CourseLab lab;
  if (node.kind == YamlKind::kScalar) {
    auto path = binder.path(node, "an item of `labs`");
    if (!path) return std::nullopt;
    lab.workspace = *std::move(path);
  } else {
    if (!binder.mapping(node, "a lab of `labs`", lab_keys())) {
      binder.wrong_type(node, "an item of `labs`", "a path, or a mapping with `workspace`");
      return std::nullopt;
    }
    const YamlNode* workspace = value_of(node, "workspace");
    if (workspace == nullptr) {
      binder.missing(node, "a lab", "workspace");
      return std::nullopt;
    }
    auto path = binder.path(*workspace, "workspace");
    if (!path) return std::nullopt;
    lab.workspace = *std::move(path);
    if (const YamlNode* title = value_of(node, "title"))
      keep(binder.line(*title, "title"), lab.title);
    if (const YamlNode* text = value_of(node, "description"))
      keep(binder.text(*text, "description"), lab.description);
    if (const YamlNode* name = value_of(node, "name")) {
      auto found = binder.name(*name, "name", workspace_name_fault);
      if (!found) return std::nullopt;
      lab.name = std::move(found->value);
    }
  }
  if (!lab.name.empty()) return lab;
  lab.name = folder_name(lab.workspace.value);
  if (const auto fault = workspace_name_fault(lab.name)) {
    Diagnostic& wrong = binder.error("R2W0104", "`" + lab.name + "` cannot be the name of a lab",
                                     node.range, fault->why);
    wrong.fix.push_back("give it one: `name: lab1`");
    return std::nullopt;
  }
  return lab;
}

void read_labs(Binder& binder, const YamlNode& node, Course& course) {
  std::set<std::string> names;
  binder.list(node, "labs", [&](const YamlNode& item) {
    auto lab = read_lab(binder, item);
    if (!lab) return;
    if (lab->name == kReserved || lab->name.ends_with(".zip") || lab->name.ends_with(".html")) {
      binder
          .error("R2W0103", "a lab cannot be named `" + lab->name + "`", item.range,
                 lab->name == kReserved ? "the labs share a folder of that name"
                                        : "it is the name of a folder")
          .fix.emplace_back("give it another name: `name: lab1`");
    } else if (!names.insert(lab->name).second) {
      binder
          .error("R2W0103", "two labs are named `" + lab->name + "`", item.range,
                 "this is the second")
          .fix.emplace_back("give it another name: `name: " + lab->name + "_2`");
    } else {
      course.labs.push_back(*std::move(lab));
    }
  });
  if (course.labs.empty() && !binder.failed())
    binder.error("R2W0103", "the course has no labs", node.range);
}

}  // namespace

Outcome<Course> read_course(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  Outcome<YamlDocument> document = parse_yaml(source);
  if (!document) return document.errors();
  Binder binder(source);
  binder.add(std::move(document->problems));
  const YamlNode& root = document->root;
  Course course;
  if (!binder.mapping(root, "the course", course_keys())) {
    binder.wrong_type(root, "course", "a mapping")
        .why.push_back("a course begins with `schema: 1`");
    return binder.take_errors();
  }
  if (!check_schema(binder, root)) return binder.take_errors();
  if (const YamlNode* name = value_of(root, "name")) {
    keep(binder.name(*name, "name", workspace_name_fault), course.name);
  } else {
    binder.missing(root, "the course", "name");
  }
  if (const YamlNode* title = value_of(root, "title"))
    keep(binder.line(*title, "title"), course.title);
  if (const YamlNode* words = value_of(root, "text"))
    keep(binder.text(*words, "text"), course.text);
  if (const YamlNode* labs = value_of(root, "labs")) {
    read_labs(binder, *labs, course);
  } else {
    binder.missing(root, "the course", "labs");
  }
  if (course.title.empty()) course.title = course.name;
  if (!binder.failed()) return course;
  return binder.errors_in_order();
}

}  // namespace ros2wasm
