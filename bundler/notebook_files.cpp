// See notebook_files.hpp.
#include "bundler/notebook_files.hpp"

#include <algorithm>

#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/page_bags.hpp"

namespace ros2wasm {

Outcome<std::vector<Spanned<std::string>>> read_notebook(ReadWorkspace& workspace) {
  const Manifest& manifest = workspace.manifest;
  if (!manifest.ui_notebook) return std::vector<Spanned<std::string>>();
  auto notebook = read_page_notebook(workspace.folder, *manifest.ui_notebook);
  if (!notebook) return std::move(notebook).errors();
  workspace.notebook = std::move(*notebook);
  return notebook_modules(shown_path(workspace.folder / manifest.ui_notebook->value,
                                     workspace.folder, workspace.shown_folder),
                          workspace.notebook->code);
}

namespace {

/// Its files are among the page's then, each once.
void add_notebook(const ReadWorkspace& workspace, PlanInput& input, PackNotes& notes) {
  if (!workspace.notebook) return;
  input.notebook = NotebookInput{.file = workspace.notebook->files.front().path, .compiled = {}};
  for (const PageFile& file : workspace.notebook->files) {
    notes.watched.push_back(workspace.folder / file.path);
    if (std::none_of(input.text.begin(), input.text.end(),
                     [&](const PageFile& one) { return one.path == file.path; }))
      input.text.push_back(file);
  }
}

}  // namespace

Outcome<Done> add_page(const ReadWorkspace& workspace, PlanInput& input, PackNotes& notes) {
  auto page = read_page_files(workspace.folder, workspace.manifest);
  if (!page) return std::move(page).errors();
  for (const auto* files : {&page->text, &page->bags})
    for (const PageFile& file : *files) notes.watched.push_back(workspace.folder / file.path);
  input.text = std::move(page->text);
  input.bags = std::move(page->bags);
  add_notebook(workspace, input, notes);
  return Done{};
}

}  // namespace ros2wasm
