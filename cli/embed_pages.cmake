# Writes explain_pages.cpp: cmake -D PAGES=dir -D OUT=file -P embed_pages.cmake
file(GLOB pages "${PAGES}/R2W*.md")
list(SORT pages)
set(rows "")
foreach(page IN LISTS pages)
  get_filename_component(code "${page}" NAME_WE)
  file(READ "${page}" text)
  string(APPEND rows "    {\"${code}\", R\"~~~(${text})~~~\"},\n")
endforeach()
set(source "// Generated from cli/explain/ by embed_pages.cmake.
#include \"cli/explain_pages.hpp\"

#include <array>

namespace ros2wasm {
namespace {
constexpr auto kPages = std::to_array<ExplainPage>({
${rows}});
}  // namespace

std::span<const ExplainPage> explain_pages() { return kPages; }

}  // namespace ros2wasm
")
file(WRITE "${OUT}" "${source}")
