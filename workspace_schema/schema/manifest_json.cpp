// See manifest_json.hpp.
#include "workspace_schema/schema/manifest_json.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/secret_text.hpp"
#include "workspace_schema/schema/check_json.hpp"

namespace ros2wasm {
namespace {

void write_double(JsonWriter& json, double number) {
  if (std::isnan(number)) {
    json.string(".nan");
  } else if (std::isinf(number)) {
    json.string(number < 0 ? "-.inf" : ".inf");
  } else {
    std::array<char, 40> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    std::string text(buffer.data(), end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    json.raw_number(text);
  }
}

void texts(JsonWriter& json, std::string_view key,
           const std::vector<Spanned<std::string>>& values) {
  json.key(key).begin_array();
  for (const auto& value : values) json.string(value.value);
  json.end_array();
}

void write_sources(JsonWriter& json, const std::vector<NamedSource>& sources) {
  if (sources.empty()) return;
  json.key("sources").begin_array();
  for (const NamedSource& source : sources) {
    json.begin_object().field(source_kind_word(source.kind), with_masked_secrets(source.place));
    if (!source.revision.empty()) json.field("revision", source.revision);
    if (!source.sha256.empty()) json.field("sha256", source.sha256);
    if (!source.packages.empty()) {
      json.key("packages").begin_array();
      for (const std::string& name : source.packages) json.string(name);
      json.end_array();
    }
    json.end_object();
  }
  json.end_array();
}

std::string_view output_word(NodeOutput output) {
  switch (output) {
    case NodeOutput::kScreen:
      return "screen";
    case NodeOutput::kLog:
      return "log";
    case NodeOutput::kBoth:
      return "both";
  }
  return "screen";
}

/// Files and inline values in the order in which they apply.
void write_parameters(JsonWriter& json, const NodeEntry& node) {
  json.key("parameters").begin_array();
  std::size_t files = 0;
  bool open = false;
  const auto file_up_to = [&](std::size_t count) {
    if (open && files < count) {
      json.end_object();
      open = false;
    }
    for (; files < count; ++files) json.string(node.parameter_files[files].value);
  };
  for (const ParameterEntry& entry : node.parameters) {
    file_up_to(entry.files_before);
    if (!open) json.begin_object();
    open = true;
    json.key(entry.name);
    write_parameter(json, entry.value);
  }
  file_up_to(node.parameter_files.size());
  if (open) json.end_object();
  json.end_array();
}

void write_node(JsonWriter& json, const NodeEntry& node) {
  json.begin_object()
      .field("package", node.package.value)
      .field("executable", node.executable.value);
  if (node.name) json.field("name", node.name->value);
  if (node.name_space) json.field("namespace", node.name_space->value);
  json.key("remappings").begin_array();
  for (const auto& [from, to] : node.remappings) {
    json.begin_object().field("from", from).field("to", to).end_object();
  }
  json.end_array();
  write_parameters(json, node);
  json.key("arguments").begin_array();
  for (const std::string& argument : node.arguments) json.string(argument);
  json.end_array();
  json.field("output", output_word(node.output)).field_boolean("respawn", node.respawn);
  json.end_object();
}

void write_budget(JsonWriter& json, const SiteBudget& budget) {
  if (!budget.total && !budget.compressed) return;
  json.key("budget").begin_object();
  if (budget.total) json.key("total").unsigned_integer(budget.total->value);
  if (budget.compressed) json.key("compressed").unsigned_integer(budget.compressed->value);
  json.end_object();
}

void write_wheels(JsonWriter& json, const std::vector<WheelEntry>& wheels) {
  json.key("wheels").begin_array();
  for (const WheelEntry& wheel : wheels) {
    json.begin_object().field(wheel.is_url ? "url" : "file",
                              with_masked_secrets(wheel.place.value));
    if (!wheel.sha256.empty()) json.field("sha256", wheel.sha256);
    json.end_object();
  }
  json.end_array();
}

void write_python(JsonWriter& json, const Manifest& manifest) {
  if (manifest.wheels.empty() && manifest.python_packages.empty() && !manifest.python_index &&
      !manifest.python_lock)
    return;
  json.key("python").begin_object();
  if (!manifest.wheels.empty()) write_wheels(json, manifest.wheels);
  if (!manifest.python_packages.empty()) texts(json, "packages", manifest.python_packages);
  if (manifest.python_index) json.field("index", with_masked_secrets(manifest.python_index->value));
  if (manifest.python_lock) json.field("lock", manifest.python_lock->value);
  json.end_object();
}

}  // namespace

void write_parameter(JsonWriter& json, const ParameterValue& parameter) {
  const auto list = [&json](const auto& values, const auto& write) {
    json.begin_array();
    for (const auto value : values) write(value);
    json.end_array();
  };
  if (const auto* flag = std::get_if<bool>(&parameter)) json.boolean(*flag);
  if (const auto* integer = std::get_if<std::int64_t>(&parameter)) json.integer(*integer);
  if (const auto* number = std::get_if<double>(&parameter)) write_double(json, *number);
  if (const auto* text = std::get_if<std::string>(&parameter)) json.string(*text);
  if (const auto* flags = std::get_if<std::vector<bool>>(&parameter)) {
    list(*flags, [&](bool v) { json.boolean(v); });
  }
  if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&parameter)) {
    list(*integers, [&](std::int64_t v) { json.integer(v); });
  }
  if (const auto* numbers = std::get_if<std::vector<double>>(&parameter)) {
    list(*numbers, [&](double v) { write_double(json, v); });
  }
  if (const auto* strings = std::get_if<std::vector<std::string>>(&parameter)) {
    json.begin_array();
    for (const std::string& text : *strings) json.string(text);
    json.end_array();
  }
}

std::string manifest_json(const Manifest& manifest) {
  JsonWriter json;
  json.begin_object().field_integer("schema", manifest.schema).field("name", manifest.name.value);
  json.field("title", manifest.title).field("version", manifest.version);
  json.key("authors").begin_array();
  for (const Author& author : manifest.authors) {
    json.begin_object().field("name", author.name);
    if (!author.email.empty()) json.field("email", author.email);
    if (!author.orcid.empty()) json.field("orcid", author.orcid);
    if (!author.affiliation.empty()) json.field("affiliation", author.affiliation);
    json.end_object();
  }
  json.end_array();
  json.field("license", manifest.license).field("distro", manifest.distro);
  if (manifest.citation) {
    const Citation& citation = *manifest.citation;
    json.key("citation").begin_object().field("date_released", citation.date_released);
    json.field("doi", citation.doi).field("repository", citation.repository);
    json.field("abstract", citation.abstract).key("keywords").begin_array();
    for (const std::string& keyword : citation.keywords) json.string(keyword);
    json.end_array().end_object();
  }
  json.key("channels").begin_array();
  for (const auto& channel : manifest.channels) json.string(with_masked_secrets(channel.value));
  json.end_array();
  json.field("channel_priority", word_of(manifest.channel_priority));
  if (manifest.channel_alias)
    json.field("channel_alias", with_masked_secrets(manifest.channel_alias->value));
  if (!manifest.mirrors.empty()) {
    json.key("mirrors").begin_object();
    for (const MirrorEntry& mirror : manifest.mirrors) {
      json.key(with_masked_secrets(mirror.channel.value)).begin_array();
      for (const auto& url : mirror.urls) json.string(with_masked_secrets(url.value));
      json.end_array();
    }
    json.end_object();
  }
  texts(json, "ignore_link_scripts", manifest.ignore_link_scripts);
  json.key("dependencies").begin_array();
  for (const auto& spec : manifest.dependencies) json.string(with_masked_secrets(spec.value));
  json.end_array();
  texts(json, "packages", manifest.packages);
  write_sources(json, manifest.sources);
  write_python(json, manifest);
  if (manifest.fetches_fuel)
    json.key("simulation").begin_object().key("fuel").boolean(true).end_object();
  json.key("launch");
  if (manifest.launch_file &&
      !(manifest.launch_arguments.empty() && manifest.launch_variables.empty())) {
    json.begin_object().field("file", manifest.launch_file->value);
    if (!manifest.launch_arguments.empty()) {
      json.key("arguments").begin_object();
      for (const GivenArgument& one : manifest.launch_arguments)
        json.field(one.name.value, one.value);
      json.end_object();
    }
    if (!manifest.launch_variables.empty()) {
      json.key("environment").begin_object();
      for (const auto& [name, value] : manifest.launch_variables) json.field(name, value);
      json.end_object();
    }
    json.end_object();
  } else if (manifest.launch_file) {
    json.string(manifest.launch_file->value);
  } else {
    json.begin_array();
    for (const NodeEntry& node : manifest.nodes) write_node(json, node);
    json.end_array();
  }
  if (!manifest.programs.empty()) {
    json.key("programs").begin_array();
    for (const ProgramEntry& program : manifest.programs) {
      json.begin_object().field("package", program.package.value);
      if (program.executable) json.field("executable", program.executable->value);
      json.end_object();
    }
    json.end_array();
  }
  if (!manifest.checks.empty()) {
    json.key("checks").begin_array();
    for (const CheckEntry& check : manifest.checks) {
      json.begin_object();
      write_check_fields(json, check);
      json.end_object();
    }
    json.end_array();
  }
  if (!manifest.tasks.empty()) {
    json.key("tasks").begin_array();
    for (const TaskEntry& task : manifest.tasks) {
      json.begin_object();
      write_task_texts(json, task);
      json.key("checks").begin_array();
      for (const CheckEntry& check : task.checks) {
        json.begin_object();
        write_check_aim(json, check);
        json.end_object();
      }
      json.end_array().end_object();
    }
    json.end_array();
  }
  for (const auto& [key, options] :
       {std::pair("ui", &manifest.ui), std::pair("site", &manifest.site)}) {
    json.key(key).begin_object();
    for (const auto& [name, value] : *options) json.field(name, value);
    if (options == &manifest.ui && !manifest.ui_layout.empty())
      json.key("layout").raw_value(manifest.ui_layout);
    if (options == &manifest.ui && manifest.ui_notebook)
      json.field("notebook", manifest.ui_notebook->value);
    if (options == &manifest.ui && manifest.ui_text) json.field("text", manifest.ui_text->value);
    if (options == &manifest.ui && !manifest.ui_bags.empty()) {
      json.key("bags").begin_array();
      for (const auto& bag : manifest.ui_bags) json.string(bag.value);
      json.end_array();
    }
    if (options == &manifest.site && !manifest.site_embed.empty()) {
      json.key("embed").begin_array();
      for (const auto& origin : manifest.site_embed) json.string(origin.value);
      json.end_array();
    }
    if (options == &manifest.site) write_budget(json, manifest.site_budget);
    json.end_object();
  }
  json.end_object();
  return json.text();
}

}  // namespace ros2wasm
