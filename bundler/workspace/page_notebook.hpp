// The Jupyter notebook of the page (`ui: notebook:`): a file of the site, with the images that its
// Markdown cells name, and code whose imports must be met.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "bundler/site/site_file.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct NotebookCell {
  std::size_t number = 0;  ///< among all cells of the notebook, from 1
  std::string source;      ///< of a code cell: lines for IPython only (`%`, `!`) are empty
};

/// The cells of a notebook of nbformat 4: code cells and Markdown cells, in order.
struct NotebookCells {
  std::vector<NotebookCell> code;
  std::vector<NotebookCell> markdown;
};

/// R2W0124: no JSON, another version, no cells or too many. Pure. `file` is for messages.
[[nodiscard]] Outcome<NotebookCells> notebook_cells(std::string_view text, const std::string& file);

struct PageNotebook {
  std::vector<PageFile> files;  ///< the notebook first
  std::vector<NotebookCell> code;
};

/// R2W0118 as a text of the page, R2W0124. An edge: reads files.
[[nodiscard]] Outcome<PageNotebook> read_page_notebook(const std::filesystem::path& folder,
                                                       const Spanned<std::string>& file);

/// How people name a cell: "lab.ipynb, cell 3".
[[nodiscard]] std::string cell_name(const std::string& file, const NotebookCell& cell);

/// Top-level modules that the code cannot do without and Python has not, each once. Pure.
[[nodiscard]] std::vector<Spanned<std::string>> notebook_modules(
    const std::string& file, const std::vector<NotebookCell>& code);

}  // namespace ros2wasm
