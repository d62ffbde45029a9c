// `ros2wasm grade FILE...`: shows the files that students have handed in as a table. Checks each
// signature and, with --site, that the labs are those of the given sites.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "bundler/io/files.hpp"
#include "bundler/render/course_page.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/site/site_list.hpp"
#include "bundler/verify/progress_file.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

struct Options {
  std::vector<std::string> files;
  std::vector<std::string> sites;
  bool csv = false;
};

struct Handed {
  std::string shown;
  ProgressFile file;
};

/// R2W0210, R2W0605.
Outcome<AskedTasks> site_of(const fs::path& folder) {
  const fs::path file = folder / kSiteJsonName;
  const auto text = read_file(file, kMostOfSiteJson);
  if (!text) return text.errors();
  if (const auto list = read_site_list(*text, file.string()); !list) return list.errors();
  return asked_tasks(*text, file.string());
}

/// R2W0210, R2W0605.
Outcome<CourseList> course_of(const fs::path& folder) {
  const auto text = read_file(folder / kCourseJsonName, kMostOfText);
  if (!text) return text.errors();
  return read_course_list(*text, (folder / kCourseJsonName).string());
}

/// All labs of a course.
Outcome<std::vector<AskedTasks>> labs_of(const fs::path& folder) {
  const auto course = course_of(folder);
  if (!course) return course.errors();
  std::vector<AskedTasks> sites;
  for (const PackedLab& lab : course->labs) {
    auto site = site_of(folder / lab.name);
    if (!site) return std::move(site).errors();
    site->names.push_back(lab.title);
    site->course = course->title;
    sites.push_back(*std::move(site));
  }
  return sites;
}

/// The tasks of a site, or of all labs of a course. What site_of() and course_of() say.
Outcome<std::vector<AskedTasks>> sites_of(const fs::path& folder) {
  if (is_course_of_ours(folder)) return labs_of(folder);
  auto site = site_of(folder);
  if (!site) return std::move(site).errors();
  const auto place = real_path(folder);
  if (!place) return place.errors();
  // A lab in the folder of its course, or an earlier version `LAB@HASH` of one, has the course's
  // title for it as well.
  if (is_course_of_ours(place->parent_path())) {
    const auto course = course_of(place->parent_path());
    if (!course) return course.errors();
    const std::string name = place->filename().string();
    for (const PackedLab& lab : course->labs)
      if (lab.name == name.substr(0, name.find('@'))) site->names.push_back(lab.title);
  }
  return std::vector<AskedTasks>{*std::move(site)};
}

std::size_t count(const std::vector<HandedTask>& tasks, std::string HandedTask::*when) {
  return static_cast<std::size_t>(std::count_if(
      tasks.begin(), tasks.end(), [&](const HandedTask& task) { return !(task.*when).empty(); }));
}

/// Letters of UTF-8, as a terminal shows most of them.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xC0U) != 0x80U;
  }));
}

void print_table(Console& console, const std::vector<Handed>& all) {
  std::vector<std::vector<std::string>> rows{
      {"student", "lab", "done", "hints", "solutions", "last done", "key"}};
  for (const Handed& handed : all) {
    for (const HandedLab& lab : handed.file.labs) {
      std::string last;
      for (const HandedTask& task : lab.tasks) last = std::max(last, task.done_at);
      rows.push_back({handed.file.student, lab.title,
                      std::to_string(count(lab.tasks, &HandedTask::done_at)) + "/" +
                          std::to_string(lab.tasks.size()),
                      std::to_string(count(lab.tasks, &HandedTask::hint_at)),
                      std::to_string(count(lab.tasks, &HandedTask::solution_at)),
                      last.empty() ? "-" : last, handed.file.key});
    }
  }
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] - width(row[i]) + 2, ' ');
    }
    console.result(line);
  }
}

void print_json(Console& console, const std::vector<Handed>& all) {
  JsonWriter json;
  json.begin_array();
  for (const auto& [shown, file] : all) {
    json.begin_object().field("file", shown).field("student", file.student);
    if (!file.course.empty()) json.field("course", file.course);
    json.field("exported_at", file.exported_at).field("key", file.key);
    json.key("labs").begin_array();
    for (const HandedLab& lab : file.labs) {
      json.begin_object().field("title", lab.title).field("sha256", lab.sha256);
      json.key("tasks").begin_array();
      for (const HandedTask& task : lab.tasks) {
        json.begin_object().field("title", task.title);
        for (const auto& [key, when] :
             {std::pair("done_at", &task.done_at), std::pair("hint_at", &task.hint_at),
              std::pair("solution_at", &task.solution_at)})
          if (!when->empty()) json.field(key, *when);
        json.end_object();
      }
      json.end_array().end_object();
    }
    json.end_array().end_object();
  }
  json.end_array();
  console.result(json.text());
}

/// R2W0673: one browser for several students.
void warn_of_shared_keys(Console& console, const std::vector<Handed>& all) {
  std::map<std::string, std::vector<std::string>> students;
  for (const Handed& handed : all) {
    auto& names = students[handed.file.key];
    if (std::find(names.begin(), names.end(), handed.file.student) == names.end())
      names.push_back(handed.file.student);
  }
  for (const auto& [key, names] : students) {
    if (names.size() < 2) continue;
    Diagnostic warning{.code = "R2W0673",
                       .severity = Severity::kWarning,
                       .message = std::to_string(names.size()) +
                                  " students have handed in from one browser, with the key " + key,
                       .why = {},
                       .fix = {}};
    for (const std::string& name : names) warning.why.push_back(name);
    console.report(warning);
  }
}

int grade(Context& context, const Options& options) {
  std::vector<AskedTasks> sites;
  Diagnostics faults;
  for (const std::string& folder : options.sites) {
    auto found = sites_of(folder);
    if (!found) return context.console.fail(found.errors());
    sites.insert(sites.end(), found->begin(), found->end());
  }
  std::vector<Handed> all;
  for (const std::string& name : options.files) {
    const auto text = read_file(name, kMostOfProgressFile);
    if (!text) {
      append(faults, text.errors());
      continue;
    }
    auto file = read_progress_file(*text, name);
    if (!file) {
      append(faults, file.errors());
      continue;
    }
    Diagnostics others;
    if (!options.sites.empty()) others = check_progress(*file, sites, name);
    if (const auto lacking = lacking_labs(*file, sites, name); lacking && others.empty())
      context.console.report(*lacking);
    if (others.empty()) all.push_back({.shown = name, .file = *std::move(file)});
    append(faults, others);
  }
  warn_of_shared_keys(context.console, all);
  if (context.json) {
    print_json(context.console, all);
  } else if (options.csv) {
    std::string rows = progress_csv_head();
    for (const Handed& handed : all) rows += progress_csv(handed.file, handed.shown);
    context.console.result_text(rows);
  } else if (!all.empty()) {
    print_table(context.console, all);
  }
  if (options.sites.empty() && !all.empty())
    context.console.remark("only signatures were checked; --site SITE compares with a site");
  return faults.empty() ? 0 : context.console.fail(faults);
}

}  // namespace

CommandBody grade_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.rest("FILE", options->files, "files that students have handed in");
  arguments.values("--site", options->sites, "SITE",
                   "folder of the site, or of the course, that the files must be of");
  arguments.flag("--csv", options->csv, "one row for each task, for a spreadsheet");
  arguments.examples({"ros2wasm grade handed/*.json --site course",
                      "ros2wasm grade handed/*.json --site course --csv > grades.csv"});
  return [options](Context& context) {
    if (!options->files.empty()) return grade(context, *options);
    return context.console.fail(Diagnostic{.code = "R2W0902",
                                           .kind = FailureKind::kCommandLine,
                                           .message = "no file was given",
                                           .why = {"students export one on the page of a lab"},
                                           .fix = {"ros2wasm grade handed/*.json"}});
  };
}

}  // namespace ros2wasm
