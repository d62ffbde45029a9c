// See page_text.hpp.
#include "bundler/workspace/page_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

#include "bundler/io/files.hpp"
#include "bundler/workspace/page_file.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostText = std::size_t{1} << 20;
constexpr std::size_t kMostBytes = std::size_t{16} << 20;
constexpr std::array<std::string_view, 6> kImages{".png", ".jpg", ".jpeg", ".gif", ".svg", ".webp"};

/// `%20` and the like; nothing for a broken one, or for a byte that no name has.
std::optional<std::string> percent_decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    const auto digit = [&](std::size_t at) {
      if (at >= text.size()) return -1;
      const char c = text[at];
      if (c >= '0' && c <= '9') return c - '0';
      if (c >= 'a' && c <= 'f') return c - 'a' + 10;
      if (c >= 'A' && c <= 'F') return c - 'A' + 10;
      return -1;
    };
    const int high = digit(i + 1);
    const int low = digit(i + 2);
    if (high < 0 || low < 0) return std::nullopt;
    const int byte = high * 16 + low;
    if (byte < 0x20 || byte == 0x7f) return std::nullopt;
    out += static_cast<char>(byte);
    i += 2;
  }
  return out;
}

/// `https:`, `data:`, `//host`, `/root`, `#place`: nothing of the workspace's folder.
bool is_address(std::string_view path) {
  if (path.empty() || path.front() == '/' || path.front() == '#' || path.front() == '?')
    return true;
  const std::size_t colon = path.find(':');
  return colon != std::string_view::npos && path.find('/') > colon;
}

/// The line without its code spans: their text, and nothing else, is blanked.
std::string without_code_spans(std::string_view line) {
  std::string out(line);
  for (std::size_t i = 0; i < out.size();) {
    if (out[i] != '`') {
      ++i;
      continue;
    }
    std::size_t ticks = i;
    while (ticks < out.size() && out[ticks] == '`') ++ticks;
    const std::size_t length = ticks - i;
    std::size_t end = ticks;
    while (end < out.size()) {
      if (out[end] != '`') {
        ++end;
        continue;
      }
      std::size_t close = end;
      while (close < out.size() && out[close] == '`') ++close;
      if (close - end == length) break;
      end = close;
    }
    if (end >= out.size()) {
      i = ticks;
      continue;
    }
    std::fill(out.begin() + static_cast<std::ptrdiff_t>(i),
              out.begin() + static_cast<std::ptrdiff_t>(end + length), ' ');
    i = end + length;
  }
  return out;
}

/// The mark of a fenced block at the beginning of a line: "```" or more, "~~~" or more.
std::string_view fence_of(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string_view::npos || begin > 3) return {};
  const char mark = line[begin];
  if (mark != '`' && mark != '~') return {};
  std::size_t end = begin;
  while (end < line.size() && line[end] == mark) ++end;
  return end - begin >= 3 ? line.substr(begin, end - begin) : std::string_view();
}

/// Two hidden ends and what is between them are blanked, over several lines too.
class Comments {
 public:
  /// `line` has no code any more; `after` is the rest of the text.
  void blank(std::string& line, std::string_view after) {
    for (std::size_t at = 0;;) {
      if (!open_) {
        at = line.find("<!--", at);
        if (at == std::string::npos) return;
        const bool is_block = line.find_first_not_of(' ') == at && at < 4;
        // In the middle of a line an end must come; a block goes on to the end of the text.
        if (!is_block && line.find("-->", at + 4) == std::string::npos && !comes_end(after)) return;
        open_ = true;
      }
      const std::size_t end = line.find("-->", at);
      open_ = end == std::string::npos;
      const std::size_t until = open_ ? line.size() : end + 3;
      std::fill(line.begin() + static_cast<std::ptrdiff_t>(at),
                line.begin() + static_cast<std::ptrdiff_t>(until), ' ');
      if (open_) return;
      at = until;
    }
  }

  [[nodiscard]] bool is_open() const { return open_; }

 private:
  /// The text is searched once: without an end in it, there is none in its later part either.
  bool comes_end(std::string_view after) {
    if (!no_end_) no_end_ = after.find("-->") == std::string_view::npos;
    return !no_end_;
  }

  bool open_ = false;
  bool no_end_ = false;
};

/// `- `, `* `, `+ `, `1. `, `1) `.
bool begins_list(std::string_view line) {
  std::size_t at = line.find_first_not_of(' ');
  if (at == std::string_view::npos) return false;
  const std::size_t begin = at;
  while (at < line.size() && line[at] >= '0' && line[at] <= '9') ++at;
  if (at == line.size()) return false;
  const std::string_view marks = at == begin ? "-*+" : ".)";
  return marks.find(line[at]) != std::string_view::npos &&
         (at + 1 == line.size() || line[at + 1] == ' ' || line[at + 1] == '\t');
}

/// Which lines are code because they are indented. What stands in lists is taken for text.
class Indented {
 public:
  bool is_code(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) {
      after_blank_ = true;
      return false;
    }
    const bool is_deep = begin >= 4 || line.substr(0, begin).find('\t') != std::string_view::npos;
    if (begins_list(line) && !is_deep)
      in_list_ = true;
    else if (begin == 0 && after_blank_)
      in_list_ = false;
    // Within a paragraph such a line goes on with it.
    const bool found = is_deep && after_blank_ && !in_list_;
    after_blank_ = found;
    return found;
  }

 private:
  bool after_blank_ = true;  ///< or after such code
  bool in_list_ = false;
};

constexpr std::size_t kLongestPath = 4096;  ///< bytes; no file has a longer one

/// Each character is looked at a few times only, whatever the line repeats.
void images_of_line(std::string_view text, std::set<std::string>& known,
                    std::vector<std::string>& found) {
  std::size_t words = 0;     // where the words of the image end
  std::size_t end = 0;       // where its path does
  std::size_t answered = 0;  // the last `words`: several `![` may share one `](path)`
  for (std::size_t at = text.find("!["); at != std::string_view::npos;
       at = text.find("![", at + 2)) {
    if (at > 0 && text[at - 1] == '\\') continue;
    if (words < at + 2) words = text.find(']', at + 2);
    if (words == std::string_view::npos) return;
    if (words == answered) continue;
    answered = words;
    if (words + 1 >= text.size() || text[words + 1] != '(') continue;
    if (end < words + 2) end = text.find_first_of(" \t)", words + 2);
    if (end == std::string_view::npos) return;
    if (end - words > kLongestPath) continue;
    std::string_view path = text.substr(words + 2, end - words - 2);
    if (text[end] != ')') {  // only a title may follow
      const std::size_t quote = text.find_first_not_of(" \t", end);
      if (quote == std::string_view::npos || (text[quote] != '"' && text[quote] != ')')) continue;
    }
    if (is_address(path)) continue;
    path = path.substr(0, path.find_first_of("?#"));
    auto decoded = percent_decoded(path);
    if (!decoded || decoded->empty()) continue;
    if (known.insert(*decoded).second) found.push_back(std::move(*decoded));
  }
}

enum class Taken { kText, kImage };

/// Files of the page, each once, together not too large.
class FileTaker {
 public:
  /// `most` bytes of a text.
  FileTaker(const fs::path& folder, std::size_t most) : folder_(folder), most_(most) {}

  [[nodiscard]] const std::vector<PageFile>& files() const { return files_; }

  /// R2W0118. `file` is what names it in the manifest.
  std::optional<Diagnostic> take(const Spanned<std::string>& file, const fs::path& relative,
                                 Taken what) {
    const bool image = what == Taken::kImage;
    const std::string path = relative.lexically_normal().generic_string();
    if (leaves_folder(path)) return page_file_refused(file, path, kNotInFolder);
    std::string ending = relative.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (image && std::find(kImages.begin(), kImages.end(), ending) == kImages.end())
      return page_file_refused(file, path, "the page shows png, jpg, gif, svg and webp");
    const auto known = std::any_of(files_.begin(), files_.end(),
                                   [&](const PageFile& one) { return one.path == path; });
    if (known) return std::nullopt;
    const auto real = find_page_file(folder_, file, path);
    if (!real) return real.errors().front();
    std::error_code error;
    if (size_ + fs::file_size(*real, error) > (image ? kMostBytes : most_))
      return page_file_refused(file, path,
                               image ? "the text and its images have more than 16 MiB together"
                                     : "it has more than " + std::to_string(most_ >> 20) + " MiB");
    auto bytes = read_file(*real, kMostOfData);
    if (!bytes) return bytes.errors().front();
    size_ += bytes->size();
    files_.push_back({.path = path, .bytes = std::move(*bytes)});
    return std::nullopt;
  }

 private:
  const fs::path& folder_;
  std::size_t most_;
  std::size_t size_ = 0;
  std::vector<PageFile> files_;
};

}  // namespace

std::vector<std::string> markdown_images(std::string_view markdown) {
  std::vector<std::string> found;
  std::set<std::string> known;
  std::string fence;
  Comments comments;
  Indented indented;
  while (!markdown.empty()) {
    const std::size_t end = std::min(markdown.find('\n'), markdown.size());
    const std::string_view line = markdown.substr(0, end);
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
    const std::string_view mark = fence_of(line);
    if (!fence.empty()) {
      if (!mark.empty() && mark.front() == fence.front() && mark.size() >= fence.size())
        fence.clear();
      continue;
    }
    if (!comments.is_open()) {
      const bool is_code = indented.is_code(line);
      if (!mark.empty()) fence = mark;
      if (is_code || !mark.empty()) continue;
    }
    std::string text = comments.is_open() ? std::string(line) : without_code_spans(line);
    comments.blank(text, markdown);
    images_of_line(text, known, found);
  }
  return found;
}

Outcome<std::vector<PageFile>> read_with_images(const fs::path& folder,
                                                const Spanned<std::string>& file, std::size_t most,
                                                const ImagesOf& images_of) {
  FileTaker taker(folder, most);
  if (auto problem = taker.take(file, fs::path(file.value), Taken::kText))
    return *std::move(problem);
  const fs::path beside = fs::path(taker.files().front().path).parent_path();
  Diagnostics problems;
  const auto images = images_of(std::string(taker.files().front().bytes));
  if (!images) return images.errors();
  for (const std::string& image : *images)
    if (auto problem = taker.take(file, beside / fs::path(image), Taken::kImage))
      problems.push_back(*problem);
  if (!problems.empty()) return problems;
  return taker.files();
}

Outcome<std::vector<PageFile>> read_page_text(const fs::path& folder,
                                              const Spanned<std::string>& file) {
  return read_with_images(folder, file, kMostText, [](const std::string& text) {
    return Outcome<std::vector<std::string>>(markdown_images(text));
  });
}

Outcome<std::vector<PageFile>> read_task_images(const fs::path& folder,
                                                const std::vector<TaskEntry>& tasks) {
  FileTaker taker(folder, kMostText);
  Diagnostics problems;
  for (const TaskEntry& task : tasks) {
    for (const std::string* text : {&task.text, &task.hint, &task.solution}) {
      for (const std::string& image : markdown_images(*text)) {
        auto problem = taker.take(task.title, fs::path(image), Taken::kImage);
        if (!problem) continue;
        problem->label = "named in this task";
        problems.push_back(*std::move(problem));
      }
    }
  }
  if (!problems.empty()) return problems;
  return taker.files();
}

}  // namespace ros2wasm
