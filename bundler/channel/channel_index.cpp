// See channel_index.hpp.
#include "bundler/channel/channel_index.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_set>
#include <utility>

#include "bundler/channel/channel_address.hpp"
#include "bundler/channel/channel_network.hpp"
#include "bundler/channel/index_files.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "bundler/channel/shard_index.hpp"
#include "bundler/channel/subdir_index.hpp"
#include "bundler/channel/transport.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/conda/spec_channel.hpp"

namespace ros2wasm {
namespace {

constexpr const char* kElsewhere = "linux-64";  ///< looked at only to explain what is missing
constexpr std::size_t kSubdirs = 2;
std::array<std::string, kSubdirs> subdirs_of(const ChannelRoots& roots) {
  return {roots.platform, "noarch"};
}

/// The index of one folder of a channel.
Outcome<std::unique_ptr<SubdirIndex>> open_subdir(IndexFile file, RecordPlace place,
                                                  const ChannelRoots& roots,
                                                  const Cancellation& cancellation) {
  RepodataSource source{
      .file = std::move(file.file), .url = std::move(file.url), .place = std::move(place)};
  switch (file.format) {
    case IndexFormat::kShards:
      return open_shards(std::move(source), roots);
    case IndexFormat::kBzip2: {
      const auto text = bzip2_text(source.file, source.url);
      if (!text) return text.errors();
      return index_repodata(*text, std::move(source));
    }
    case IndexFormat::kZstd:
    case IndexFormat::kPlain:
      break;
  }
  return open_repodata(std::move(source), roots.cache, cancellation);
}

Diagnostic no_channel(const ChannelSource& source, const ChannelRoots& roots) {
  if (roots.network.offline && is_network_url(source.name)) {
    return Diagnostic{.code = "R2W0232",
                      .kind = FailureKind::kEnvironment,
                      .message = "the index of `" + source.name + "` is not on this machine",
                      .span = source.span,
                      .label = "not brought yet",
                      .why = {"--offline uses only what was downloaded before"}};
  }
  return Diagnostic{
      .code = "R2W0201",
      .kind = FailureKind::kEnvironment,
      .message = "there is no channel at `" + source.name + "`",
      .span = source.span,
      .label = "no channel here",
      .why = {"it has neither `noarch/repodata.json` nor `emscripten-wasm32/repodata.json` "
              "(nor a packed form of either)"}};
}

using SubdirIndexes = std::vector<std::unique_ptr<SubdirIndex>>;

/// `files`: what was found in the folders of this channel.
Outcome<SubdirIndexes> open_channel(const ChannelSource& source,
                                    std::span<Outcome<std::optional<IndexFile>>> files,
                                    const ChannelRoots& roots, const Cancellation& cancellation) {
  SubdirIndexes subdirs;
  for (std::size_t i = 0; i < kSubdirs; ++i) {
    if (cancellation.requested()) return interrupted();
    if (!files[i]) return std::move(files[i]).errors();
    if (!*files[i]) continue;
    const std::string subdir = subdirs_of(roots)[i];
    auto index = open_subdir(std::move(**files[i]),
                             {.channel = source.name,
                              .subdir = subdir,
                              .base_url = channel_base_url(source.name) + "/" + subdir},
                             roots, cancellation);
    if (!index) return std::move(index).errors();
    subdirs.push_back(std::move(*index));
  }
  if (subdirs.empty()) return no_channel(source, roots);
  return subdirs;
}

}  // namespace

struct OpenChannels::State {
  struct Channel {
    std::string name;
    SubdirIndexes subdirs;
  };

  std::vector<Channel> channels;
  ChannelRoots roots;
  SpecTable checked;
  SpecTable unchecked{false};

  static void add_sorted(std::vector<std::string_view>& all,
                         std::span<const std::string_view> more) {
    const auto before = static_cast<std::ptrdiff_t>(all.size());
    all.insert(all.end(), more.begin(), more.end());
    std::inplace_merge(all.begin(), all.begin() + before, all.end());
  }

  /// Most requests are fulfilled without a look at them.
  const std::vector<std::string>& names() {
    if (names_) return *names_;
    std::vector<std::string_view> all;
    for (const Channel& channel : channels) {
      for (const auto& subdir : channel.subdirs) add_sorted(all, subdir->names());
    }
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return names_.emplace(all.begin(), all.end());
  }

  /// Names that no channel has for sites: do they have them for people's own machines? What cannot
  /// be read says nothing; the request fails anyway.
  [[nodiscard]] std::map<std::string, std::string> elsewhere(
      std::span<const std::string> wanted, const Cancellation& cancellation) const {
    std::map<std::string, std::string> places;
    if (roots.platform == kElsewhere) return places;
    ChannelRoots hasty = roots;
    hasty.network.download.retries = 0;
    for (const Channel& channel : channels) {
      const std::string folder = channel_base_url(channel.name) + "/" + kElsewhere;
      auto files = bring_index_files(std::vector<std::string>{folder}, hasty, cancellation);
      if (!files.front() || !*files.front()) continue;
      const auto other = open_subdir(
          std::move(**files.front()),
          {.channel = channel.name, .subdir = kElsewhere, .base_url = folder}, roots, cancellation);
      if (!other) continue;
      const auto there = (*other)->names();
      for (const std::string& name : wanted) {
        if (std::binary_search(there.begin(), there.end(), name))
          places.emplace(name, std::string(kElsewhere) + " in " + channel.name);
      }
    }
    return places;
  }

  [[nodiscard]] std::vector<std::string> channel_names() const {
    std::vector<std::string> all;
    for (const Channel& channel : channels) all.push_back(channel.name);
    return all;
  }

  [[nodiscard]] static RepoIndex nothing_yet(const std::shared_ptr<State>& state) {
    RepoIndex index;
    index.channels = state->channel_names();
    index.names = [state] { return state->names(); };
    return index;
  }

 private:
  std::optional<std::vector<std::string>> names_;
};

namespace {

struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const {
    return std::hash<std::string_view>()(text);
  }
};

/// Reads records name by name, from the specs of a request outwards.
class Reach {
 public:
  using AllNames = std::function<const std::vector<std::string>&()>;
  Reach(SpecTable& table, AllNames names) : table_(table), names_(std::move(names)) {}

  void begin(const std::string& text) {
    const auto& spec = table_.parsed(text);
    if (!spec) return;
    const auto name = spec->exact_name();
    if (name && spec->channel()) named_channel_.insert(*name);
    add_names(*spec);
  }

  /// The names that were found since the last time, sorted.
  std::vector<std::string> next() {
    std::sort(waiting_.begin(), waiting_.end());
    return std::exchange(waiting_, {});
  }

  /// Adds the names that the records from `first` on depend on.
  void follow(const RepoIndex& index, std::size_t first) {
    for (std::size_t i = first; i < index.records.size(); ++i) {
      for (const std::string& text : index.records[i].depends) {
        if (const auto name = plain_name(text)) {
          add(*name);
        } else if (followed_.insert(text).second) {
          if (const auto& spec = table_.parsed(text)) add_names(*spec);
        }
      }
    }
  }

  /// A request that names the channel of a package wants to see all channels' records of it.
  [[nodiscard]] bool names_channel(const std::string& name) const {
    return named_channel_.contains(name);
  }

 private:
  void add_names(const MatchSpec& spec) {
    if (const auto name = spec.exact_name()) {
      add(*name);
      return;
    }
    for (const std::string& there : names_()) {
      if (spec.name().matches(there)) add(there);
    }
  }

  void add(std::string_view name) {
    if (seen_.contains(name)) return;
    waiting_.push_back(*seen_.emplace(name).first);
  }

  SpecTable& table_;
  AllNames names_;
  std::unordered_set<std::string, TextHash, std::equal_to<>> seen_;
  std::unordered_set<std::string> followed_;  ///< texts of dependencies that had to be parsed
  std::set<std::string> named_channel_;
  std::vector<std::string> waiting_;
};

}  // namespace

const std::vector<std::string>& OpenChannels::names() const {
  return state_->names();
}

std::vector<std::string> OpenChannels::channels() const {
  return state_->channel_names();
}

Outcome<RepoIndex> OpenChannels::reachable(std::span<const std::string> specs,
                                           ChannelPriority priority,
                                           const Cancellation& cancellation) const {
  RepoIndex index = State::nothing_yet(state_);
  index.elsewhere = [state = state_, cancellation](std::span<const std::string> names) {
    return state->elsewhere(names, cancellation);
  };
  Reach reach(state_->unchecked,
              [this]() -> const std::vector<std::string>& { return state_->names(); });
  for (const std::string& text : specs) reach.begin(text);
  for (std::vector<std::string> wave = reach.next(); !wave.empty(); wave = reach.next()) {
    const std::size_t wave_begin = index.records.size();
    for (const State::Channel& channel : state_->channels) {
      const std::size_t first = index.records.size();
      for (const auto& subdir : channel.subdirs) {
        auto done = subdir->read(wave, state_->unchecked, index, cancellation);
        if (!done) return std::move(done).errors();
      }
      if (priority != ChannelPriority::kStrict) continue;
      std::set<std::string_view> found;  // hidden in the channels that follow
      for (std::size_t i = first; i < index.records.size(); ++i) {
        if (i == first || index.records[i].name != index.records[i - 1].name)
          found.insert(index.records[i].name);
      }
      std::erase_if(wave, [&](const std::string& name) {
        return found.contains(name) && !reach.names_channel(name);
      });
    }
    reach.follow(index, wave_begin);
  }
  return index;
}

Outcome<RepoIndex> OpenChannels::everything(const Cancellation& cancellation) const {
  RepoIndex index = State::nothing_yet(state_);
  for (const State::Channel& channel : state_->channels) {
    for (const auto& subdir : channel.subdirs) {
      const std::vector<std::string> all(subdir->names().begin(), subdir->names().end());
      auto done = subdir->read(all, state_->checked, index, cancellation);
      if (!done) return std::move(done).errors();
    }
  }
  return index;
}

namespace {

/// A folder has many spellings, and is one channel all the same.
bool same_channel(const std::string& a, const std::string& b, const ChannelRoots& roots) {
  if (a == b) return true;
  const auto folder = local_channel_folder(a, roots.working_directory);
  const auto other = local_channel_folder(b, roots.working_directory);
  if (!folder || !other) return false;
  std::error_code error;
  const auto real = std::filesystem::weakly_canonical(*folder / "", error);
  return !error && real == std::filesystem::weakly_canonical(*other / "", error) && !error;
}

}  // namespace

Outcome<std::vector<ChannelSource>> channel_addresses(std::span<const ChannelSource> channels,
                                                      ChannelRoots& roots) {
  std::vector<ChannelSource> addresses;
  Diagnostics errors;
  for (const ChannelSource& source : channels) {
    std::error_code error;
    const bool folder = is_bare_channel_name(source.name) &&
                        std::filesystem::is_directory(roots.working_directory / source.name, error);
    auto name =
        folder ? Outcome<std::string>(source.name) : channel_address(source.name, roots.network);
    if (!name) {
      append(errors, std::move(name).errors(), source.span);
      continue;
    }
    if (std::none_of(addresses.begin(), addresses.end(), [&](const ChannelSource& other) {
          return same_channel(other.name, *name, roots);
        }))
      addresses.push_back({.name = std::move(*name), .span = source.span});
  }
  if (!errors.empty()) return errors;
  return addresses;
}

Outcome<Done> add_named_channel(std::string& spec, const std::optional<SourceSpan>& span,
                                std::vector<ChannelSource>& addresses, ChannelRoots& roots) {
  const auto parsed = MatchSpec::parse(spec);
  if (!parsed || !parsed->channel() || !parsed->channel()->exact()) return Done{};
  const std::string& named = parsed->channel()->text();
  const bool is_address = named.find("://") != std::string::npos;
  if (!is_address && std::any_of(addresses.begin(), addresses.end(), [&](const ChannelSource& one) {
        return parsed->accepts_channel(one.name);
      }))
    return Done{};
  const ChannelSource source{.name = named, .span = span};
  auto more = channel_addresses({&source, 1}, roots);
  if (!more) return std::move(more).errors();
  auto found = std::find_if(addresses.begin(), addresses.end(), [&](const ChannelSource& one) {
    return same_channel(one.name, more->front().name, roots);
  });
  if (found == addresses.end()) found = addresses.insert(found, std::move(more->front()));
  if (parsed->accepts_channel(found->name)) return Done{};
  auto text = with_channel(*parsed, found->name);
  if (!text) {
    Diagnostics errors;
    append(errors, std::move(text).errors(), span);
    return errors;
  }
  spec = std::move(*text);
  return Done{};
}

Outcome<OpenChannels> open_channels(std::span<const ChannelSource> channels,
                                    const ChannelRoots& roots, const Cancellation& cancellation,
                                    const ProgressSink& progress) {
  OpenChannels open;
  open.state_ = std::make_shared<OpenChannels::State>();
  open.state_->roots = roots;
  const auto report = [&](const std::string& item, std::size_t done) {
    if (!progress) return;
    progress({.step = "index",
              .item = item,
              .done = done,
              .total = channels.size(),
              .unit = "channels"});
  };
  Diagnostics errors;
  std::set<std::string> seen;
  std::vector<const ChannelSource*> distinct;
  std::vector<std::string> folders;
  for (const ChannelSource& source : channels) {
    if (!seen.insert(source.name).second) continue;
    distinct.push_back(&source);
    for (const std::string& subdir : subdirs_of(roots))
      folders.push_back(channel_base_url(source.name) + "/" + subdir);
  }
  if (!distinct.empty()) report(distinct.front()->name, 0);
  auto files = bring_index_files(folders, roots, cancellation);
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    const ChannelSource& source = *distinct[i];
    report(source.name, i);
    auto subdirs =
        open_channel(source, std::span(files).subspan(i * kSubdirs, kSubdirs), roots, cancellation);
    if (subdirs) {
      open.state_->channels.push_back({.name = source.name, .subdirs = std::move(*subdirs)});
    } else {
      append(errors, std::move(subdirs).errors(), source.span);
    }
  }
  if (!errors.empty()) return errors;
  report({}, channels.size());
  return open;
}

Outcome<RepoIndex> load_channels(std::span<const ChannelSource> channels, const ChannelRoots& roots,
                                 const Cancellation& cancellation, const ProgressSink& progress) {
  const auto open = open_channels(channels, roots, cancellation, progress);
  if (!open) return open.errors();
  return open->everything(cancellation);
}

Outcome<std::filesystem::path> embedded_channel(const std::filesystem::path& executable) {
  const std::filesystem::path folder = executable.parent_path();
  const std::array<std::filesystem::path, 2> places{
      folder / "channel", (folder / ".." / "share" / "ros2wasm" / "channel").lexically_normal()};
  for (const std::filesystem::path& place : places) {
    std::error_code error;
    if (std::filesystem::is_regular_file(place / "noarch" / "repodata.json", error)) return place;
  }
  return Diagnostic{.code = "R2W0204",
                    .kind = FailureKind::kEnvironment,
                    .message = "the channel that comes with ros2wasm is not there",
                    .why = {"looked for `noarch/repodata.json` in `" + places[0].string() +
                            "` and `" + places[1].string() + "`"}};
}

}  // namespace ros2wasm
