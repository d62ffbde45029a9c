#ifndef AMENT_INDEX_CPP__GET_SEARCH_PATHS_HPP_
#define AMENT_INDEX_CPP__GET_SEARCH_PATHS_HPP_

#include <list>
#include <string>

namespace ament_index_cpp {

/// The prefixes of AMENT_PREFIX_PATH that are there. Throws std::runtime_error without any in it.
std::list<std::string> get_search_paths();

}  // namespace ament_index_cpp

#endif  // AMENT_INDEX_CPP__GET_SEARCH_PATHS_HPP_
