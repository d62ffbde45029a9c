// `ros2wasm explain CODE`: the page of a code, embedded at build time from cli/explain/.
#include <memory>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/embedded_texts.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

/// "101", "0101", "w0101" and "r2w0101" all mean R2W0101.
std::string full_code(std::string word) {
  for (char& c : word) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  const std::size_t digits_at = word.find_last_not_of("0123456789");
  std::string digits = digits_at == std::string::npos ? word : word.substr(digits_at + 1);
  if (digits.empty() || digits.size() > 4) return word;
  digits.insert(0, 4 - digits.size(), '0');
  return "R2W" + digits;
}

/// First line of a page without its `# `.
std::string_view title_of(const EmbeddedText& page) {
  std::string_view line = page.text.substr(0, page.text.find('\n'));
  while (!line.empty() && (line.front() == '#' || line.front() == ' ')) line.remove_prefix(1);
  return line;
}

int list_pages(Context& context) {
  if (context.json) {
    JsonWriter json;
    json.begin_array();
    for (const EmbeddedText& page : explain_pages()) {
      json.begin_object().field("code", page.name).field("title", title_of(page)).end_object();
    }
    json.end_array();
    context.console.result(json.text());
    return 0;
  }
  for (const EmbeddedText& page : explain_pages()) context.console.result(title_of(page));
  return 0;
}

int show_page(Context& context, const std::string& word) {
  const std::string code = full_code(word);
  for (const EmbeddedText& page : explain_pages()) {
    if (page.name != code) continue;
    if (context.json) {
      JsonWriter json;
      json.begin_object().field("code", page.name).field("title", title_of(page));
      json.field("text", page.text).end_object();
      context.console.result(json.text());
    } else {
      context.console.result_text(page.text);
    }
    return 0;
  }
  return context.console.fail(
      Diagnostic{.code = "R2W0902",
                 .kind = FailureKind::kCommandLine,
                 .message = "there is no error code `" + word + "`",
                 .why = {"codes are `R2W` and four digits; `ros2wasm explain` alone lists them"}});
}

}  // namespace

CommandBody explain_command(Arguments& arguments) {
  const auto code = std::make_shared<std::string>();
  arguments.optional("CODE", *code,
                     "an error code, such as R2W0101; without it, all codes are listed");
  arguments.examples({"ros2wasm explain R2W0101", "ros2wasm explain 101"});
  return [code](Context& context) {
    return code->empty() ? list_pages(context) : show_page(context, *code);
  };
}

}  // namespace ros2wasm
