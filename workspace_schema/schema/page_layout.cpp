// See page_layout.hpp.
#include "workspace_schema/schema/page_layout.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <variant>

#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

/// The panels of runtime/site/ui/panels/index.ts.
const std::vector<std::string>& page_panels() {
  static const std::vector<std::string> kPanels{
#include "page_panels.inc"
  };
  return kPanels;
}

constexpr std::size_t kMostDepth = 6;
constexpr std::size_t kMostPanels = 32;
constexpr std::size_t kMostParts = 12;
constexpr std::size_t kMostOptionsDepth = 8;

constexpr std::string_view kForms =
    "a panel (`console`), a panel with options (`plot: {...}`), or a mapping with `row`, `column` "
    "or `tabs`";

class LayoutReader {
 public:
  explicit LayoutReader(Binder& binder) : binder_(binder) {}

  std::string read(const YamlNode& node) {
    part(node, 0);
    if (panels_ > kMostPanels) {
      binder_.error("R2W0103", "`layout` has more than 32 panels", node.range);
      good_ = false;
    }
    return good_ ? json_.text() : std::string();
  }

 private:
  Diagnostic& wrong(const YamlNode& node, const std::string& message) {
    good_ = false;
    Diagnostic& error = binder_.error("R2W0103", message, node.range);
    error.why.push_back("a part of a layout is " + std::string(kForms));
    return error;
  }

  void part(const YamlNode& node, std::size_t depth) {
    if (depth > kMostDepth) {
      wrong(node, "`layout` is more than 6 deep");
      json_.null();
      return;
    }
    for (const std::string_view kind : {"row", "column", "tabs"}) {
      if (value_of(node, kind) != nullptr) {
        split(node, kind, depth);
        return;
      }
    }
    panel(node);
  }

  void split(const YamlNode& node, std::string_view kind, std::size_t depth) {
    const bool tabs = kind == "tabs";
    std::vector<KeyRow> keys{{.name = kind, .also_called = {}}};
    keys.push_back({.name = tabs ? "front" : "sizes", .also_called = {}});
    if (depth == 0) keys.push_back({.name = "shown", .also_called = {}});
    binder_.mapping(node, "a part of `layout`", keys);
    const YamlNode& list = *value_of(node, kind);
    if (list.kind != YamlKind::kSequence || list.items.empty()) {
      wrong(list, "`" + std::string(kind) + "` must be a list of its parts");
      json_.null();
      return;
    }
    if (!tabs && list.items.size() > kMostParts) {
      wrong(list, "`" + std::string(kind) + "` has more than 12 parts");
    }
    json_.begin_object().key(kind).begin_array();
    for (const YamlNode& item : list.items) tabs ? panel(item) : part(item, depth + 1);
    json_.end_array();
    if (const YamlNode* sizes = value_of(node, "sizes"); sizes != nullptr && !tabs)
      write_sizes(*sizes, list.items.size());
    if (const YamlNode* front = value_of(node, "front"); front != nullptr && tabs)
      write_front(*front, list.items.size());
    if (const YamlNode* shown = value_of(node, "shown"); shown != nullptr && depth == 0) {
      write_shown(*shown);
    }
    json_.end_object();
  }

  void write_sizes(const YamlNode& node, std::size_t count) {
    const bool right = node.kind == YamlKind::kSequence && node.items.size() == count;
    if (!right) {
      wrong(node, "`sizes` must have one number for each part");
      return;
    }
    json_.key("sizes").begin_array();
    for (const YamlNode& item : node.items) {
      const double size = number_of(item);
      if (size > 0 && size < 1e6) {
        json_.number(size);
      } else {
        wrong(item, "a size must be a number above 0 and below 1000000");
        json_.null();
      }
    }
    json_.end_array();
  }

  void write_front(const YamlNode& node, std::size_t count) {
    const YamlValue value = scalar_value(node);
    const auto* number = std::get_if<std::int64_t>(&value);
    if (node.kind != YamlKind::kScalar || number == nullptr || *number < 1 ||
        static_cast<std::size_t>(*number) > count) {
      wrong(node, "`front` must be the number of a tab, from 1");
      return;
    }
    json_.field_integer("front", *number);
  }

  /// All panels have been read.
  void write_shown(const YamlNode& node) {
    const auto id = binder_.line(node, "shown");
    if (!id) {
      good_ = false;
    } else if (std::find(ids_.begin(), ids_.end(), id->value) != ids_.end()) {
      json_.field("shown", id->value);
    } else {
      good_ = false;
      Diagnostic& unknown =
          binder_.error("R2W0102", "there is no panel `" + id->value + "` in this layout",
                        node.range, "not here");
      unknown.why.push_back("its panels are: " + name_list(ids_, 64));
      if (const auto near = nearest(id->value, ids_))
        unknown.fix.push_back("write `" + *near + "`");
    }
  }

  /// Adds the id of a panel. The second panel of a kind is `plot-2`, as the page counts them.
  void count(const std::string& name) {
    const auto before = ++counts_[name];
    ids_.push_back(before == 1 ? name : name + "-" + std::to_string(before));
  }

  void panel(const YamlNode& node) {
    panels_ += 1;
    if (node.kind == YamlKind::kScalar) {
      count(node.text);
      if (check_name(node.text, node.range)) json_.string(node.text);
      return;
    }
    if (node.kind != YamlKind::kMap || node.entries.size() != 1) {
      wrong(node, "a part of `layout` cannot be " + std::string(described(node)));
      json_.null();
      return;
    }
    const YamlEntry& entry = node.entries.front();
    count(entry.key);
    check_name(entry.key, entry.key_range);
    json_.begin_object().key(entry.key);
    options(entry.value, 0);
    json_.end_object();
  }

  bool check_name(const std::string& name, TextRange at) {
    const auto& known = page_panels();
    if (std::find(known.begin(), known.end(), name) != known.end()) return true;
    good_ = false;
    Diagnostic& unknown =
        binder_.error("R2W0102", "there is no panel `" + name + "`", at, "unknown panel");
    if (const auto near = nearest(name, known)) {
      unknown.fix.push_back("write `" + *near + "`");
    } else {
      unknown.why.push_back("the page's panels are: " + name_list(known, 64));
    }
    return false;
  }

  /// The initial options of a panel. The panel itself reads them, and uses those that it knows.
  void options(const YamlNode& node, std::size_t depth) {
    if (depth > kMostOptionsDepth) {
      wrong(node, "options of a panel are more than 8 deep");
      json_.null();
      return;
    }
    switch (node.kind) {
      case YamlKind::kNull:
        json_.null();
        return;
      case YamlKind::kScalar:
        scalar(node);
        return;
      case YamlKind::kSequence:
        json_.begin_array();
        for (const YamlNode& item : node.items) options(item, depth + 1);
        json_.end_array();
        return;
      case YamlKind::kMap:
        json_.begin_object();
        for (const YamlEntry& entry : node.entries) {
          json_.key(entry.key);
          options(entry.value, depth + 1);
        }
        json_.end_object();
        return;
    }
  }

  void scalar(const YamlNode& node) {
    const YamlValue value = scalar_value(node);
    if (const auto* flag = std::get_if<bool>(&value)) {
      json_.boolean(*flag);
    } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      json_.integer(*integer);
    } else if (const auto* real = std::get_if<double>(&value)) {
      json_.number(*real);
    } else if (std::holds_alternative<std::monostate>(value)) {
      json_.null();
    } else {
      json_.string(node.text);
    }
  }

  static double number_of(const YamlNode& node) {
    if (node.kind != YamlKind::kScalar) return 0;
    const YamlValue value = scalar_value(node);
    if (const auto* integer = std::get_if<std::int64_t>(&value))
      return static_cast<double>(*integer);
    if (const auto* real = std::get_if<double>(&value)) return *real;
    return 0;
  }

  Binder& binder_;
  JsonWriter json_;
  std::size_t panels_ = 0;
  std::vector<std::string> ids_;  ///< of the panels so far
  std::map<std::string, int> counts_;
  bool good_ = true;
};

}  // namespace

std::string read_page_layout(Binder& binder, const YamlNode& node) {
  return LayoutReader(binder).read(node);
}

}  // namespace ros2wasm
