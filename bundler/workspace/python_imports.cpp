// See python_imports.hpp.
#include "bundler/workspace/python_imports.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

namespace ros2wasm {
namespace {

/// Modules of CPython 3.12 that Pyodide 0.27 has; a test asks it.
constexpr auto kModules = std::to_array<std::string_view>({
    "__future__",
    "__main__",
    "abc",
    "aifc",
    "antigravity",
    "argparse",
    "array",
    "ast",
    "asyncio",
    "atexit",
    "audioop",
    "base64",
    "bdb",
    "binascii",
    "bisect",
    "builtins",
    "bz2",
    "cProfile",
    "calendar",
    "cgi",
    "cgitb",
    "chunk",
    "cmath",
    "cmd",
    "code",
    "codecs",
    "codeop",
    "collections",
    "colorsys",
    "compileall",
    "concurrent",
    "configparser",
    "contextlib",
    "contextvars",
    "copy",
    "copyreg",
    "crypt",
    "csv",
    "ctypes",
    "dataclasses",
    "datetime",
    "decimal",
    "difflib",
    "dis",
    "doctest",
    "email",
    "encodings",
    "enum",
    "errno",
    "faulthandler",
    "filecmp",
    "fileinput",
    "fnmatch",
    "fractions",
    "ftplib",
    "functools",
    "gc",
    "genericpath",
    "getopt",
    "getpass",
    "gettext",
    "glob",
    "graphlib",
    "gzip",
    "hashlib",
    "heapq",
    "hmac",
    "html",
    "http",
    "imaplib",
    "imghdr",
    "importlib",
    "inspect",
    "io",
    "ipaddress",
    "itertools",
    "json",
    "keyword",
    "linecache",
    "locale",
    "logging",
    "mailbox",
    "mailcap",
    "marshal",
    "math",
    "mimetypes",
    "mmap",
    "modulefinder",
    "multiprocessing",
    "netrc",
    "nntplib",
    "ntpath",
    "nturl2path",
    "numbers",
    "opcode",
    "operator",
    "optparse",
    "os",
    "pathlib",
    "pdb",
    "pickle",
    "pickletools",
    "pipes",
    "pkgutil",
    "platform",
    "plistlib",
    "poplib",
    "posix",
    "posixpath",
    "pprint",
    "profile",
    "pstats",
    "pty",
    "py_compile",
    "pyclbr",
    "pydoc",
    "pyexpat",
    "queue",
    "quopri",
    "random",
    "re",
    "reprlib",
    "rlcompleter",
    "runpy",
    "sched",
    "secrets",
    "select",
    "selectors",
    "shelve",
    "shlex",
    "shutil",
    "signal",
    "site",
    "smtplib",
    "sndhdr",
    "socket",
    "socketserver",
    "sre_compile",
    "sre_constants",
    "sre_parse",
    "stat",
    "statistics",
    "string",
    "stringprep",
    "struct",
    "subprocess",
    "sunau",
    "symtable",
    "sys",
    "sysconfig",
    "tabnanny",
    "tarfile",
    "telnetlib",
    "tempfile",
    "termios",
    "textwrap",
    "this",
    "threading",
    "time",
    "timeit",
    "token",
    "tokenize",
    "tomllib",
    "trace",
    "traceback",
    "tracemalloc",
    "tty",
    "types",
    "typing",
    "unicodedata",
    "unittest",
    "urllib",
    "uu",
    "uuid",
    "warnings",
    "wave",
    "weakref",
    "webbrowser",
    "wsgiref",
    "xdrlib",
    "xml",
    "xmlrpc",
    "zipapp",
    "zipfile",
    "zipimport",
    "zlib",
    "zoneinfo",
});

/// And those that it lacks.
constexpr auto kLacking = std::to_array<std::string_view>({
    "curses",     "dbm",      "ensurepip",  "fcntl", "grp",     "idlelib",     "lib2to3",
    "lzma",       "msilib",   "msvcrt",     "nis",   "nt",      "ossaudiodev", "pwd",
    "pydoc_data", "readline", "resource",   "spwd",  "sqlite3", "ssl",         "syslog",
    "tkinter",    "turtle",   "turtledemo", "venv",  "winreg",  "winsound",
});

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f';
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// The end of the string that starts at `at`, behind its last quote.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const std::string_view quote = text.substr(at, 1);
  const std::string triple(3, quote[0]);
  if (text.substr(at, 3) == triple) {
    std::size_t end = at + 3;
    while (end < text.size() && text.substr(end, 3) != triple) end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 3, text.size());
  }
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != quote[0] && text[end] != '\n')
    end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

/// Strings become `_`, comments blanks; all else keeps its place, and so do lines.
std::string only_code(std::string text) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    char filler = ' ';
    if (text[at] == '#') {
      end = std::min(text.find('\n', at), text.size());
    } else if (text[at] == '"' || text[at] == '\'') {
      end = end_of_string(text, at);
      filler = '_';
    }
    if (end == at) ++at;
    for (; at < end; ++at) {
      if (text[at] != '\n') text[at] = filler;
    }
  }
  return text;
}

/// Words and signs of one logical line, each with its place.
struct Word {
  std::string_view text;
  std::size_t at;
};

class Reader {
 public:
  Reader(std::string_view text, const std::string& file)
      : text_(text), code_(only_code(std::string(text))), file_(file) {}

  std::vector<PythonImport> read() {
    while (at_ < code_.size()) logical_line();
    note_attributes();
    return std::move(found_);
  }

 private:
  void logical_line() {
    std::size_t indent = 0;
    while (at_ < code_.size() && is_space(code_[at_])) {
      indent += code_[at_] == '\t' ? 8 : 1;
      ++at_;
    }
    const std::vector<Word> words = words_to_the_end();
    if (words.empty()) return;
    while (!blocks_.empty() && blocks_.back().indent >= indent) blocks_.pop_back();
    const std::string_view first = words.front().text;
    const bool needed = std::all_of(blocks_.begin(), blocks_.end(),
                                    [](const Block& block) { return block.always_runs; });
    if (words.back().text == ":")
      blocks_.push_back({.indent = indent, .always_runs = first == "class" || first == "with"});
    // Several statements on one line, the first behind the colon of a block.
    std::size_t start = 0;
    bool always = needed;
    for (std::size_t i = 0; i <= words.size(); ++i) {
      const bool is_colon = i < words.size() && words[i].text == ":" && start == 0 && i > 0;
      if (i < words.size() && words[i].text != ";" && !is_colon) continue;
      statement({words.begin() + static_cast<std::ptrdiff_t>(start),
                 words.begin() + static_cast<std::ptrdiff_t>(i)},
                always);
      always = always && !is_colon;
      start = i + 1;
    }
  }

  /// Up to the newline that ends the statement; brackets and backslashes hide others.
  std::vector<Word> words_to_the_end() {
    std::vector<Word> words;
    int depth = 0;
    const std::string_view code = code_;
    while (at_ < code.size()) {
      const char c = code[at_];
      if (c == '\n' && depth <= 0) {
        ++at_;
        break;
      }
      if (c == '\\' || c == '\n' || is_space(c)) {
        at_ += c == '\\' ? 2 : 1;
        continue;
      }
      const std::size_t start = at_;
      if (is_word(c)) {
        while (at_ < code.size() && is_word(code[at_])) ++at_;
      } else {
        ++at_;
        depth += c == '(' || c == '[' || c == '{' ? 1 : c == ')' || c == ']' || c == '}' ? -1 : 0;
      }
      words.push_back({code.substr(start, at_ - start), start});
    }
    return words;
  }

  /// A dotted name from `i` on.
  static std::string dotted(const std::vector<Word>& words, std::size_t& i) {
    std::string name;
    while (i < words.size() && words[i].text == ".") {
      name += ".";
      ++i;
    }
    for (; i < words.size() && words[i].text != "import" && is_word(words[i].text[0]); ++i) {
      name += words[i].text;
      if (i + 1 >= words.size() || words[i + 1].text != ".") return ++i, name;
      name += ".";
      ++i;
    }
    return name;
  }

  void statement(const std::vector<Word>& words, bool needed) {
    if (words.size() < 2) return;
    std::size_t i = 1;
    if (words[0].text == "import") {
      while (i < words.size()) {
        const Word& place = words[i];
        std::string module = dotted(words, i);
        if (!module.empty()) {
          const bool renamed = i + 1 < words.size() && words[i].text == "as";
          const std::string_view name = renamed ? words[i + 1].text : place.text;
          if (module.find('.') == std::string::npos) whole_[name].push_back(found_.size());
          add(std::move(module), {}, place, needed);
        }
        while (i < words.size() && words[i].text != ",") ++i;
        ++i;
      }
    } else if (words[0].text == "from") {
      const Word& place = words[i];
      std::string module = dotted(words, i);
      if (module.empty() || i >= words.size() || words[i].text != "import") return;
      std::vector<std::string> names;
      for (++i; i < words.size(); ++i) {
        if (words[i].text == "as") {
          ++i;
        } else if (is_word(words[i].text[0]) || words[i].text == "*") {
          names.emplace_back(words[i].text);
        }
      }
      add(std::move(module), std::move(names), place, needed);
    }
  }

  void add(std::string module, std::vector<std::string> names, const Word& place, bool needed) {
    const std::size_t before =
        place.at == 0 ? std::string_view::npos : text_.rfind('\n', place.at - 1);
    const std::size_t start = before == std::string_view::npos ? 0 : before + 1;
    const auto line =
        1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place.at), '\n');
    found_.push_back(
        {.module = module,
         .names = std::move(names),
         .needed = needed,
         .span = {.file = file_,
                  .line = static_cast<std::uint32_t>(line),
                  .column = static_cast<std::uint32_t>(place.at - start + 1),
                  .length = static_cast<std::uint32_t>(module.size()),
                  .line_text = std::string(text_.substr(start, text_.find('\n', start) - start))}});
  }

  /// For each `NAME.ATTRIBUTE` of a module that is called NAME in this file.
  void note_attributes() {
    if (whole_.empty()) return;
    std::map<std::string_view, std::set<std::string>> used;
    const std::string_view code = code_;
    for (std::size_t at = 0; at < code.size();) {
      if (!is_word(code[at])) {
        ++at;
        continue;
      }
      const std::size_t start = at;
      while (at < code.size() && is_word(code[at])) ++at;
      const auto module = whole_.find(code.substr(start, at - start));
      const bool is_inner = start > 0 && code[start - 1] == '.';
      if (module == whole_.end() || is_inner || at >= code.size() || code[at] != '.') continue;
      const std::size_t name = ++at;
      while (at < code.size() && is_word(code[at])) ++at;
      if (at > name) used[module->first].emplace(code.substr(name, at - name));
    }
    for (const auto& [name, attributes] : used) {
      for (const std::size_t index : whole_.at(name))
        found_[index].attributes.assign(attributes.begin(), attributes.end());
    }
  }

  struct Block {
    std::size_t indent;
    bool always_runs;
  };

  std::string_view text_;
  std::string code_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::vector<Block> blocks_;
  std::vector<PythonImport> found_;
  /// Places in `found_` of modules that are imported whole, by their names in the file.
  std::map<std::string_view, std::vector<std::size_t>> whole_;
};

template <typename List>
bool has(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

std::vector<PythonImport> python_imports(std::string_view text, const std::string& file) {
  return Reader(text, file).read();
}

bool is_python_script(std::string_view text) {
  if (!text.starts_with("#!")) return false;
  return text.substr(0, text.find('\n')).find("python") != std::string_view::npos;
}

bool is_python_module(std::string_view top_level) {
  return has(kModules, top_level) || is_lacking_python_module(top_level) ||
         top_level.starts_with('_');
}

bool is_lacking_python_module(std::string_view top_level) {
  return has(kLacking, top_level);
}

}  // namespace ros2wasm
